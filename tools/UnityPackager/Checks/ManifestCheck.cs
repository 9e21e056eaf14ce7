using System.Text.Json;
using System.Text.RegularExpressions;

namespace NeuronMocap.UnityPackager.Checks;

/// <summary>Checks that the package manager accepts package.json, and that package.json lists exactly the existing samples.</summary>
internal static partial class ManifestCheck
{
    private const string Manifest = "package.json";

    private static readonly string[] Texts = ["name", "version", "displayName", "description", "unity", "license"];

    /// <summary>Describes why the manifest cannot be checked. Null if it can.</summary>
    public static string? FindUnreadable(StagedPackage package)
    {
        if (!package.Files.TryGetValue(Manifest, out byte[]? text))
            return $"{Manifest} is missing";

        try
        {
            using var manifest = JsonDocument.Parse(text);
            string? missing = Array.Find(Texts, name => GetText(manifest.RootElement, name).Length == 0);
            return missing is null ? null : $"{Manifest}: {missing} is missing";
        }
        catch (JsonException exception)
        {
            return $"{Manifest}: {exception.Message}";
        }
    }

    public static IReadOnlyList<string> Check(StagedPackage package)
    {
        using var manifest = JsonDocument.Parse(package.Files[Manifest]);
        return [.. CheckTexts(manifest.RootElement), .. CheckSamples(manifest.RootElement, package), .. CheckFiles(package)];
    }

    private static IEnumerable<string> CheckTexts(JsonElement manifest)
    {
        if (!Name().IsMatch(GetText(manifest, "name")))
            yield return "package.json: name must be lower-case letters with dots between them";
        if (!SemanticVersion().IsMatch(GetText(manifest, "version")))
            yield return "package.json: version must look like 1.2.3 or 1.2.3-preview.1";
        if (!UnityVersion().IsMatch(GetText(manifest, "unity")))
            yield return "package.json: unity must look like 2021.3";

        foreach (string name in (string[])["author", "repository"])
        {
            if (!manifest.TryGetProperty(name, out JsonElement part) || GetText(part, "url").Length == 0)
                yield return $"package.json: {name} lacks its url";
        }

        if (manifest.TryGetProperty("dependencies", out JsonElement dependencies))
        {
            foreach (JsonProperty dependency in dependencies.EnumerateObject().Where(static dependency => !dependency.Name.StartsWith("com.unity.modules.", StringComparison.Ordinal)))
                yield return $"package.json: {dependency.Name} is not a module of Unity";
        }
    }

    private static IEnumerable<string> CheckSamples(JsonElement manifest, StagedPackage package)
    {
        List<string> listed = [];
        foreach (JsonElement sample in manifest.TryGetProperty("samples", out JsonElement samples) ? samples.EnumerateArray().ToArray() : [])
        {
            string path = GetText(sample, "path");
            listed.Add(path);
            if (GetText(sample, "displayName").Length == 0 || GetText(sample, "description").Length == 0)
                yield return $"package.json: the sample {path} lacks its name or description";
            if (!package.AssetFolders.Contains(path) || AssetPath.ParentOf(path) != AssetPath.Samples)
                yield return $"package.json: the sample {path} does not exist";
        }

        foreach (string folder in package.AssetFolders.Where(folder => AssetPath.ParentOf(folder) == AssetPath.Samples).Except(listed))
            yield return $"package.json: does not list the sample {folder}";
    }

    private static IEnumerable<string> CheckFiles(StagedPackage package) =>
        ((string[])["README.md", "CHANGELOG.md", "LICENSE.md", "Documentation~/index.md"])
            .Where(path => !package.Files.ContainsKey(path))
            .Select(static path => $"{path} is missing");

    private static string GetText(JsonElement element, string name) =>
        element.ValueKind == JsonValueKind.Object && element.TryGetProperty(name, out JsonElement value) && value.ValueKind == JsonValueKind.String ? value.GetString()! : string.Empty;

    [GeneratedRegex(@"^[a-z][a-z0-9-]*(\.[a-z][a-z0-9-]*){2,}$", RegexOptions.ExplicitCapture, matchTimeoutMilliseconds: 1000)]
    private static partial Regex Name();

    [GeneratedRegex(@"^\d+\.\d+\.\d+(-[0-9A-Za-z.-]+)?$", RegexOptions.ExplicitCapture, matchTimeoutMilliseconds: 1000)]
    private static partial Regex SemanticVersion();

    [GeneratedRegex(@"^\d{4}\.\d+$", RegexOptions.ExplicitCapture, matchTimeoutMilliseconds: 1000)]
    private static partial Regex UnityVersion();
}
