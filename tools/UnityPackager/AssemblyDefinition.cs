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
    IReadOnlyList<string> VersionDefines,
    bool OverrideReferences,
    bool AutoReferenced)
{
    private const string TestConstraint = "UNITY_INCLUDE_TESTS";

    public bool IsEditorOnly => IncludePlatforms is ["Editor"];

    /// <summary>Whether Unity compiles it only together with another package, whose assemblies it may reference.</summary>
    public bool NeedsOtherPackage => DefineConstraints.Intersect(VersionDefines, StringComparer.Ordinal).Any();

    public bool IsTest => DefineConstraints.Contains(TestConstraint);

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

        string[] GetVersionDefines() =>
            root.TryGetProperty("versionDefines", out JsonElement list) ? [.. list.EnumerateArray().Select(static item => item.GetProperty("define").GetString() ?? string.Empty)] : [];

        string[] GetTexts(string name) =>
            root.TryGetProperty(name, out JsonElement list) ? [.. list.EnumerateArray().Select(static text => text.GetString() ?? string.Empty)] : [];
    }

    public static IReadOnlyList<AssemblyDefinition> FindAll(StagedPackage package) =>
        [.. package.AssetFiles.Where(IsDefinition).Select(path => Parse(path, package.Files[path]))];

    public static bool IsDefinition(string path) => path.EndsWith(".asmdef", StringComparison.Ordinal);

    /// <summary>Gets the definition to which a source belongs, or null.</summary>
    public static AssemblyDefinition? Owning(string source, IEnumerable<AssemblyDefinition> definitions) => definitions
        .Where(definition => source.StartsWith(definition.Folder + '/', StringComparison.Ordinal))
        .MaxBy(static definition => definition.Folder.Length);
}
