using System.Text.RegularExpressions;
using NeuronMocap.Packaging.Tests.Infrastructure;
using NeuronMocap.Tests.Infrastructure;

namespace NeuronMocap.Packaging.Tests.Documentation;

public sealed partial class DocumentationTests
{
    private static readonly string Folder = Path.Combine(ThePackage.Folder, "Documentation~");

    [Fact]
    public void The_components_page_matches_the_sources() => Check("components.md", ComponentPage.Create(PackageSources.All));

    [Fact]
    public void The_mapping_diagram_matches_the_library() => Check("images/mapping.svg", MappingDiagram.Create());

    [Fact]
    public void Every_field_of_every_component_has_a_tooltip()
    {
        PackageSources sources = PackageSources.All;
        string[] types = [.. sources.Components.Select(static component => component.Type.Identifier.Text)];
        Assert.NotEmpty(types);
        Assert.Empty(types.SelectMany(type => sources.FieldsOf(type).Where(static field => string.IsNullOrWhiteSpace(field.Tooltip)).Select(field => $"{type}: {field.Name}")));
    }

    [Fact]
    public void Every_range_is_documented_in_numbers()
    {
        PackageSources sources = PackageSources.All;
        string[] ranges = [.. sources.Components.SelectMany(component => sources.FieldsOf(component.Type.Identifier.Text)).Select(static field => field.Range).OfType<string>().Distinct(StringComparer.Ordinal)];
        Assert.NotEmpty(ranges);
        Assert.All(ranges, static range => Assert.Matches(@"^-?[\d.]+ (to [\d.]+|or more)$", range));
    }

    [Fact]
    public void Links_and_pictures_exist()
    {
        string[] pages = [.. Directory.EnumerateFiles(Folder, "*.md"), Path.Combine(ThePackage.Folder, "README.md"), .. Directory.EnumerateFiles(Path.Combine(ThePackage.Folder, "Samples~"), "*.md", SearchOption.AllDirectories)];
        List<string> broken = [];
        foreach (string page in pages)
        {
            foreach (string target in Link().Matches(File.ReadAllText(page)).Select(static match => match.Groups["target"].Value))
            {
                string[] parts = target.Split('#');
                string file = parts[0].Length == 0 ? page : Path.Combine(Path.GetDirectoryName(page)!, parts[0]);
                if (!File.Exists(file) || (parts.Length > 1 && !AnchorsOf(file).Contains(parts[1])))
                    broken.Add($"{Path.GetFileName(page)}: {target}");
            }
        }

        Assert.Empty(broken);
    }

    [Fact]
    public void Every_page_is_linked_from_the_first()
    {
        string[] reached = [.. Link().Matches(File.ReadAllText(Path.Combine(Folder, "index.md"))).Select(static match => match.Groups["target"].Value.Split('#')[0]).Distinct(StringComparer.Ordinal)];
        Assert.Empty(Directory.EnumerateFiles(Folder, "*.md").Select(Path.GetFileName).Except(["index.md", .. reached]));
    }

    [Fact]
    public void The_retargeting_picture_matches_the_library() => Check("images/retargeting.svg", File.ReadAllText(Repository.PathOf("docs", "guide", "retargeting.svg")));

    [Fact]
    public void Every_picture_is_used_on_a_page()
    {
        string[] shown = [.. Directory.EnumerateFiles(Folder, "*.md").SelectMany(static page => Link().Matches(File.ReadAllText(page))).Select(static match => match.Groups["target"].Value)];
        Assert.Empty(Directory.EnumerateFiles(Path.Combine(Folder, "images")).Select(static picture => $"images/{Path.GetFileName(picture)}").Except(shown));
    }

    // Menu items on pages are written from their first level: *GameObject > NeuronMocap > Source*.
    [Fact]
    public void Documented_menu_items_exist_in_the_sources()
    {
        string sources = string.Concat(Directory.EnumerateFiles(Path.Combine(ThePackage.Folder, "Editor"), "*.cs", SearchOption.AllDirectories).Select(File.ReadAllText));
        string[] pages = [.. Directory.EnumerateFiles(Folder, "*.md"), Path.Combine(ThePackage.Folder, "README.md"), Repository.PathOf("README.md")];
        string[] items = [.. pages.SelectMany(static page => Menu().Matches(File.ReadAllText(page))).Select(static match => match.Groups["item"].Value).Distinct(StringComparer.Ordinal)];

        Assert.Contains("Quick Start Scene", items);
        Assert.All(items, item => Assert.True(
            sources.Contains($"[MenuItem(Menu + \"{item}\"", StringComparison.Ordinal) || sources.Contains($"[MenuItem(\"Window/NeuronMocap/{item}\"", StringComparison.Ordinal),
            item));
    }

    // NEURONMOCAP_UPDATE_DOCS=1 rewrites the file.
    private static void Check(string name, string expected)
    {
        string path = Path.Combine(Folder, name);
        if (Environment.GetEnvironmentVariable("NEURONMOCAP_UPDATE_DOCS") == "1")
        {
            Directory.CreateDirectory(Path.GetDirectoryName(path)!);
            File.WriteAllText(path, expected);
        }

        Assert.Equal(expected, File.ReadAllText(path));
    }

    private static IEnumerable<string> AnchorsOf(string page) => Heading().Matches(File.ReadAllText(page))
        .Select(static match => NoAnchor().Replace(match.Groups["title"].Value.ToLowerInvariant(), string.Empty).Trim().Replace(' ', '-'));

    [GeneratedRegex(@"\]\((?!https?:)(?<target>[^)\s]+)\)", RegexOptions.ExplicitCapture, matchTimeoutMilliseconds: 1000)]
    private static partial Regex Link();

    [GeneratedRegex(@"\*(GameObject|Window) > NeuronMocap > (?<item>[^*]+)\*", RegexOptions.ExplicitCapture, matchTimeoutMilliseconds: 1000)]
    private static partial Regex Menu();

    [GeneratedRegex("^#+ (?<title>.*)$", RegexOptions.Multiline | RegexOptions.ExplicitCapture, matchTimeoutMilliseconds: 1000)]
    private static partial Regex Heading();

    [GeneratedRegex("[^a-z0-9 _-]", RegexOptions.ExplicitCapture, matchTimeoutMilliseconds: 1000)]
    private static partial Regex NoAnchor();
}
