using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using NeuronMocap.Tests.Infrastructure;
using NeuronMocap.UnityPackager;

namespace NeuronMocap.Packaging.Tests.Infrastructure;

/// <summary>
/// Compiles a package as Unity does: the sources of each assembly definition, with only those libraries of the package that the definition names. A
/// stand-in replaces Unity itself.
/// </summary>
internal sealed class UnityCompiler
{
    private static readonly MetadataReference[] Framework = [.. ((string)AppContext.GetData("TRUSTED_PLATFORM_ASSEMBLIES")!)
        .Split(Path.PathSeparator)
        .Where(static file => Path.GetDirectoryName(file) == Path.GetDirectoryName(typeof(object).Assembly.Location))
        .Select(static file => MetadataReference.CreateFromFile(file))];

    // Those that a project may lack.
    private static readonly string[] OtherPackages = ["Unity.InputSystem", "Unity.LiveCapture", "Unity.Timeline"];

    private readonly StagedPackage _package;
    private readonly MetadataReference[] _unity;
    private readonly CSharpParseOptions _options;
    private readonly IReadOnlyList<AssemblyDefinition> _all;
    private readonly AssemblyDefinition[] _usable;
    private readonly Dictionary<string, MetadataReference> _libraries = new(StringComparer.Ordinal);
    private readonly Dictionary<string, MetadataReference> _installed = new(StringComparer.Ordinal);
    private readonly Dictionary<string, MetadataReference> _compiled = new(StringComparer.Ordinal);

    public UnityCompiler(StagedPackage package, bool isEditor)
    {
        _package = package;
        _unity = [StandIn("UnityEngine"), .. isEditor ? (MetadataReference[])[StandIn("UnityEditor")] : []];
        _options = new(LanguageVersion.CSharp9, DocumentationMode.None, preprocessorSymbols: ["UNITY_2021_3_OR_NEWER", .. isEditor ? (string[])["UNITY_EDITOR"] : []]);
        _all = AssemblyDefinition.FindAll(package);
        _usable = [.. _all.Where(definition => !definition.IsTest && (isEditor || !definition.IsEditorOnly))];
    }

    /// <summary>The assembly definitions, without tests and without those that need a package that is not installed.</summary>
    public AssemblyDefinition[] Definitions => [.. _usable.Where(definition => _installed.Count > 0 || !definition.NeedsOtherPackage)];

    /// <summary>The names of the compiled assemblies.</summary>
    public IReadOnlyCollection<string> Compiled => _compiled.Keys;

    /// <summary>Installs the packages that a project may lack.</summary>
    public void InstallOtherPackages()
    {
        foreach (string other in OtherPackages)
            _installed.Add(other, StandIn(other));
    }

    /// <summary>Compiles all assemblies that are not compiled yet, references first. Fails with the first errors.</summary>
    public void CompileAll()
    {
        while (Definitions.FirstOrDefault(definition => !_compiled.ContainsKey(definition.Name) && definition.References.All(Exists)) is { } definition)
            CompileOne(definition);
    }

    /// <summary>Returns the errors of a script in a project with the package. The script sees the component assembly and the libraries.</summary>
    public IEnumerable<Diagnostic> FindErrors(string script)
    {
        if (!_compiled.ContainsKey("NeuronMocap.Unity"))
            CompileOne(Definitions.Single(static definition => definition.Name == "NeuronMocap.Unity"));

        return Emit("Assembly-CSharp", [CSharpSyntaxTree.ParseText(script, _options)], [_compiled["NeuronMocap.Unity"], .. MirroredFile.Assemblies.Select(static name => $"{name}.dll").Select(Library)], Stream.Null);
    }

    private bool Exists(string assembly) => _compiled.ContainsKey(assembly) || _installed.ContainsKey(assembly);

    private MetadataReference Find(string assembly) => _compiled.TryGetValue(assembly, out MetadataReference? own) ? own : _installed[assembly];

    private void CompileOne(AssemblyDefinition definition)
    {
        SyntaxTree[] sources = [.. _package.AssetFiles
            .Where(path => path.EndsWith(".cs", StringComparison.Ordinal) && AssemblyDefinition.Owning(path, _all) == definition)
            .Select(path => CSharpSyntaxTree.ParseText(_package.ReadText(path), _options, path))];
        Assert.NotEmpty(sources);

        using var image = new MemoryStream();
        Assert.Empty(Emit(definition.Name, sources, [.. definition.References.Select(Find), .. definition.PrecompiledReferences.Select(Library)], image));
        _compiled.Add(definition.Name, MetadataReference.CreateFromImage(image.ToArray()));
    }

    private IEnumerable<Diagnostic> Emit(string assembly, SyntaxTree[] sources, IEnumerable<MetadataReference> references, Stream image) => CSharpCompilation
        .Create(assembly, sources, [.. Framework, .. _unity, .. references], new CSharpCompilationOptions(OutputKind.DynamicallyLinkedLibrary))
        .Emit(image, cancellationToken: TestContext.Current.CancellationToken)
        .Diagnostics
        .Where(static problem => problem.Severity == DiagnosticSeverity.Error);

    private MetadataReference Library(string name)
    {
        if (!_libraries.TryGetValue(name, out MetadataReference? library))
            _libraries.Add(name, library = MetadataReference.CreateFromImage(_package.Files[$"{MirroredFile.Libraries}/{name}"]));

        return library;
    }

    private static PortableExecutableReference StandIn(string assembly) =>
        MetadataReference.CreateFromFile(Repository.PathOf("tests", "Unity", assembly, "bin", ThePackage.Configuration, "netstandard2.1", $"{assembly}.dll"));
}
