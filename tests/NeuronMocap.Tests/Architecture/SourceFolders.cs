using System.Reflection.Metadata;
using System.Reflection.Metadata.Ecma335;

namespace NeuronMocap.Tests.Architecture;

/// <summary>The folder that declares each type of an assembly, from its portable symbols: by row of the type, relative to a root.</summary>
internal static class SourceFolders
{
    // Types without a method body, such as enums and interfaces, name their documents in a record of this kind (Portable PDB format).
    private static readonly Guid TypeDocuments = new("932E74BC-DBA9-4478-8D46-0F32A7BAB3D3");

    /// <summary>A type in several files has the folder nearest to the root. Types outside the root, and generated ones, are omitted.</summary>
    public static IReadOnlyDictionary<uint, string> Read(string assembly, string root)
    {
        using FileStream file = File.OpenRead(Path.ChangeExtension(assembly, ".pdb"));
        using var symbols = MetadataReaderProvider.FromPortablePdbStream(file);
        using FileStream code = File.OpenRead(assembly);
        using var image = new System.Reflection.PortableExecutable.PEReader(code);
        MetadataReader pdb = symbols.GetMetadataReader();
        MetadataReader metadata = image.GetMetadataReader();

        Dictionary<uint, string> folders = [];
        foreach (MethodDebugInformationHandle handle in pdb.MethodDebugInformation)
        {
            MethodDebugInformation method = pdb.GetMethodDebugInformation(handle);
            if (!method.Document.IsNil)
                Add(metadata.GetMethodDefinition(handle.ToDefinitionHandle()).GetDeclaringType(), method.Document);
        }

        foreach (CustomDebugInformation information in pdb.CustomDebugInformation.Select(pdb.GetCustomDebugInformation))
        {
            if (information.Parent.Kind != HandleKind.TypeDefinition || pdb.GetGuid(information.Kind) != TypeDocuments)
                continue;

            BlobReader rows = pdb.GetBlobReader(information.Value);
            while (rows.RemainingBytes > 0)
                Add((TypeDefinitionHandle)information.Parent, MetadataTokens.DocumentHandle(rows.ReadCompressedInteger()));
        }

        return folders;

        void Add(TypeDefinitionHandle type, DocumentHandle document)
        {
            string path = pdb.GetString(pdb.GetDocument(document).Name).Replace('\\', '/');
            int start = path.IndexOf(root, StringComparison.Ordinal);
            if (start < 0)
                return;

            string inner = path[(start + root.Length)..];
            if (inner.StartsWith("obj/", StringComparison.Ordinal))
                return;

            string folder = inner[..Math.Max(0, inner.LastIndexOf('/'))];
            uint row = (uint)MetadataTokens.GetRowNumber(type);
            if (!folders.TryGetValue(row, out string? known) || folder.Length < known.Length)
                folders[row] = folder;
        }
    }
}
