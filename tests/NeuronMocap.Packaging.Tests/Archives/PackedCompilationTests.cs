using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using NeuronMocap.Packaging.Tests.Infrastructure;
using NeuronMocap.Tests.Infrastructure;
using NeuronMocap.UnityPackager;
using NeuronMocap.UnityPackager.Archives;

namespace NeuronMocap.Packaging.Tests.Archives;

// What Unity does with the tarball: it compiles each assembly definition's sources, with no other library than those in the tarball that the definition
// names. Unity itself is the stand-in.
public sealed class PackedCompilationTests
{
    private static readonly StagedPackage Package = UpmTarball.Read(UpmTarball.Create(ThePackage.Staged));

    private static readonly MetadataReference[] Framework = [.. ((string)AppContext.GetData("TRUSTED_PLATFORM_ASSEMBLIES")!)
        .Split(Path.PathSeparator)
        .Where(static file => Path.GetDirectoryName(file) == Path.GetDirectoryName(typeof(object).Assembly.Location))
        .Select(static file => MetadataReference.CreateFromFile(file))];

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void All_that_is_packed_compiles_with_nothing_else(bool isEditor)
    {
        List<MetadataReference> unity = [StandIn("UnityEngine")];
        if (isEditor)
            unity.Add(StandIn("UnityEditor"));

        AssemblyDefinition[] definitions = [.. AssemblyDefinition.FindAll(Package).Where(definition => !definition.IsTest && (isEditor || !definition.IsEditorOnly))];
        Dictionary<string, MetadataReference> compiled = new(StringComparer.Ordinal);
        while (definitions.FirstOrDefault(definition => !compiled.ContainsKey(definition.Name) && definition.References.All(compiled.ContainsKey)) is { } definition)
        {
            IEnumerable<MetadataReference> references =
            [
                .. Framework,
                .. unity,
                .. definition.References.Select(reference => compiled[reference]),
                .. definition.PrecompiledReferences.Select(static library => MetadataReference.CreateFromImage(Package.Files[$"{MirroredFile.Libraries}/{library}"])),
            ];
            compiled.Add(definition.Name, Compile(definition, definitions, references, isEditor));
        }

        Assert.Equal(isEditor ? 8 : 7, definitions.Length);
        Assert.Equal(definitions.Length, compiled.Count);
    }

    private static PortableExecutableReference Compile(AssemblyDefinition definition, AssemblyDefinition[] all, IEnumerable<MetadataReference> references, bool isEditor)
    {
        string[] symbols = ["UNITY_2021_3_OR_NEWER", .. isEditor ? (string[])["UNITY_EDITOR"] : []];
        CSharpParseOptions options = new(LanguageVersion.CSharp9, DocumentationMode.None, preprocessorSymbols: symbols);
        SyntaxTree[] sources = [.. Package.AssetFiles
            .Where(path => path.EndsWith(".cs", StringComparison.Ordinal) && AssemblyDefinition.Owning(path, all) == definition)
            .Select(path => CSharpSyntaxTree.ParseText(Package.ReadText(path), options, path))];
        Assert.NotEmpty(sources);
        var compilation = CSharpCompilation.Create(definition.Name, sources, references, new CSharpCompilationOptions(OutputKind.DynamicallyLinkedLibrary));

        using var image = new MemoryStream();
        Assert.Empty(compilation.Emit(image, cancellationToken: TestContext.Current.CancellationToken).Diagnostics.Where(static problem => problem.Severity == DiagnosticSeverity.Error));
        return MetadataReference.CreateFromImage(image.ToArray());
    }

    private static PortableExecutableReference StandIn(string assembly) =>
        MetadataReference.CreateFromFile(Repository.PathOf("tests", "Unity", assembly, "bin", ThePackage.Configuration, "netstandard2.1", $"{assembly}.dll"));
}
