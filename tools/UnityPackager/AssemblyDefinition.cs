using System.Text.Json;

namespace NeuronMocap.UnityPackager;

/// <summary>An .asmdef file. The sources below its folder, down to the next .asmdef file, form one assembly.</summary>
internal sealed record AssemblyDefinition(
    string Path,
    string Name,
    IReadOnlyList<string> References,
    IReadOnlyList<string> PrecompiledReferences,
    IReadOnlyList<string> IncludePlatforms,
    IReadOnlyList<string> DefineConstraints,
    IReadOnlyList<PackageSymbol> VersionDefines,
    bool OverrideReferences,
    bool AutoReferenced)
{
    private const string TestConstraint = "UNITY_INCLUDE_TESTS";

    public bool IsEditorOnly => IncludePlatforms is ["Editor"];

    /// <summary>Whether Unity compiles it only together with another package.</summary>
    public bool NeedsOtherPackage => NeededPackages.Any();

    public bool IsTest => DefineConstraints.Contains(TestConstraint);

    private IEnumerable<string> NeededPackages =>
        VersionDefines.Where(symbol => DefineConstraints.Contains(symbol.Define)).Select(static symbol => symbol.Package);

    private string Folder => AssetPath.ParentOf(Path) ?? string.Empty;

    /// <exception cref="JsonException">The text is not JSON, or a part of it has the wrong type.</exception>
    public static AssemblyDefinition Parse(string path, byte[] text)
    {
        using var document = JsonDocument.Parse(text);
        JsonElement root = document.RootElement;
        return new AssemblyDefinition(
            path,
            root.GetProperty("name").GetString() ?? string.Empty,
            GetTexts("references"),
            GetTexts("precompiledReferences"),
            GetTexts("includePlatforms"),
            GetTexts("defineConstraints"),
            GetVersionDefines(),
            root.TryGetProperty("overrideReferences", out JsonElement overrides) && overrides.GetBoolean(),
            !root.TryGetProperty("autoReferenced", out JsonElement auto) || auto.GetBoolean());

        PackageSymbol[] GetVersionDefines() =>
            root.TryGetProperty("versionDefines", out JsonElement list) ? [.. list.EnumerateArray().Select(static item => new PackageSymbol(GetText(item, "name"), GetText(item, "define")))] : [];

        static string GetText(JsonElement item, string name) => item.GetProperty(name).GetString() ?? string.Empty;

        string[] GetTexts(string name) =>
            root.TryGetProperty(name, out JsonElement list) ? [.. list.EnumerateArray().Select(static text => text.GetString() ?? string.Empty)] : [];
    }

    /// <summary>Whether another package that this assembly needs has the assembly. Unity names its assemblies after their packages.</summary>
    public bool MayReferenceOfOtherPackage(string assembly) =>
        NeededPackages.Any(package => Simplify(assembly).StartsWith(Simplify(package[(package.IndexOf('.', StringComparison.Ordinal) + 1)..]), StringComparison.OrdinalIgnoreCase));

    public static IReadOnlyList<AssemblyDefinition> FindAll(StagedPackage package) =>
        [.. package.AssetFiles.Where(IsDefinition).Select(path => Parse(path, package.Files[path]))];

    public static bool IsDefinition(string path) => path.EndsWith(".asmdef", StringComparison.Ordinal);

    /// <summary>Gets the definition to which a source belongs, or null.</summary>
    public static AssemblyDefinition? Owning(string source, IEnumerable<AssemblyDefinition> definitions) => definitions
        .Where(definition => source.StartsWith(definition.Folder + '/', StringComparison.Ordinal))
        .MaxBy(static definition => definition.Folder.Length);

    private static string Simplify(string name) => name.Replace(".", string.Empty, StringComparison.Ordinal).Replace("-", string.Empty, StringComparison.Ordinal);
}

/// <summary>A symbol that Unity defines where a package is, such as com.unity.timeline.</summary>
internal sealed record PackageSymbol(string Package, string Define);
