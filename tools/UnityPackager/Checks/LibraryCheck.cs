using System.Reflection.Metadata;
using System.Reflection.PortableExecutable;

namespace NeuronMocap.UnityPackager.Checks;

/// <summary>
/// Checks the libraries: only our own, dependent only on netstandard, with the version of the manifest, and without paths of the build.
/// </summary>
internal static class LibraryCheck
{
    // The root to which the projects map their folder in symbols.
    private const string MappedRoot = "/_/";

    private static readonly HashSet<string> PluginExtensions = new(
        [".dll", ".exe", ".winmd", ".so", ".dylib", ".bundle", ".framework", ".a", ".bc", ".jar", ".aar", ".androidlib", ".jslib", ".jspre", ".c", ".cpp", ".h", ".m", ".mm", ".java", ".swift"],
        StringComparer.OrdinalIgnoreCase);

    public static IEnumerable<string> Check(StagedPackage package) =>
    [
        .. package.Files.Keys.Where(IsForeign).Select(static path => $"{path}: is not one of our libraries"),
        .. MirroredFile.Assemblies.SelectMany(assembly => CheckAssembly(assembly, package)),
    ];

    // Files that Unity takes for plugins, in upper or lower case.
    private static bool IsForeign(string path) =>
        PluginExtensions.Contains(Path.GetExtension(path)) && !MirroredFile.All.Any(file => file.Path == path);

    private static IEnumerable<string> CheckAssembly(string assembly, StagedPackage package)
    {
        string path = $"{MirroredFile.Libraries}/{assembly}";
        foreach (string missing in ((string[])[".dll", ".pdb", ".xml"]).Where(extension => !package.Files.ContainsKey(path + extension)))
            yield return $"{path}{missing} is missing";

        if (package.Files.TryGetValue(path + ".dll", out byte[]? library))
        {
            foreach (string problem in CheckReferences(library, package.Version))
                yield return $"{path}.dll: {problem}";
        }

        if (package.Files.TryGetValue(path + ".pdb", out byte[]? symbols))
        {
            foreach (string problem in CheckSymbols(symbols))
                yield return $"{path}.pdb: {problem}";
        }
    }

    private static IEnumerable<string> CheckReferences(byte[] library, string version)
    {
        using var file = new PEReader(new MemoryStream(library));
        MetadataReader metadata = file.GetMetadataReader();
        foreach (AssemblyReferenceHandle handle in metadata.AssemblyReferences)
        {
            string name = metadata.GetString(metadata.GetAssemblyReference(handle).Name);
            if (name != "netstandard" && !MirroredFile.Assemblies.Contains(name))
                yield return $"needs {name}, which Unity may lack or have twice";
        }

        foreach (string member in FindReflection(metadata))
            yield return $"uses {member}: Unity strips members that are only found by reflection, unless they have [Preserve]";

        Version actual = metadata.GetAssemblyDefinition().Version;
        if (!version.StartsWith(actual.ToString(3), StringComparison.Ordinal))
            yield return $"has version {actual.ToString(3)}, package.json has {version}";
    }

    // At run time the libraries only look up names of enumeration members. Stripping keeps these with their type.
    private static IEnumerable<string> FindReflection(MetadataReader metadata)
    {
        foreach (MemberReferenceHandle handle in metadata.MemberReferences)
        {
            MemberReference member = metadata.GetMemberReference(handle);
            if (member.Parent.Kind != HandleKind.TypeReference)
                continue;

            TypeReference type = metadata.GetTypeReference((TypeReferenceHandle)member.Parent);
            string typeName = $"{metadata.GetString(type.Namespace)}.{metadata.GetString(type.Name)}";
            string name = metadata.GetString(member.Name);
            if (FindsMembers(typeName, name))
                yield return $"{typeName}.{name}";
        }
    }

    // The name and version of an assembly always exist.
    private static bool FindsMembers(string type, string name) => type switch
    {
        "System.Activator" => true,
        "System.Type" => name.StartsWith("Get", StringComparison.Ordinal) && name != "GetTypeFromHandle",
        "System.Reflection.AssemblyName" => false,
        "System.Reflection.Assembly" => name is not "GetName" and not "GetEntryAssembly",
        _ when type.EndsWith("Attribute", StringComparison.Ordinal) => false,
        _ => type.StartsWith("System.Reflection.", StringComparison.Ordinal) || type.StartsWith("System.Linq.Expressions.", StringComparison.Ordinal),
    };

    private static IEnumerable<string> CheckSymbols(byte[] symbols)
    {
        using MetadataReaderProvider provider = MetadataReaderProvider.FromPortablePdbStream(new MemoryStream(symbols));
        MetadataReader metadata = provider.GetMetadataReader();
        return [.. metadata.Documents
            .Select(handle => metadata.GetString(metadata.GetDocument(handle).Name))
            .Where(static name => !name.StartsWith(MappedRoot, StringComparison.Ordinal))
            .Take(1)
            .Select(static name => $"contains {name}, a path of the computer that built it")];
    }
}
