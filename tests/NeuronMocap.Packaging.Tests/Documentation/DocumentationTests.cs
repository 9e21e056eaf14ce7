using System.Text.RegularExpressions;
using NeuronMocap.Packaging.Tests.Infrastructure;

namespace NeuronMocap.Packaging.Tests.Documentation;

public sealed partial class DocumentationTests
{
    private static readonly string Folder = Path.Combine(ThePackage.Folder, "Documentation~");

    [Fact]
    public void The_page_of_components_says_what_the_sources_say() => Check("components.md", ComponentPage.Create(PackageSources.Load()));

    [Fact]
    public void The_diagram_of_the_mapping_shows_what_the_library_maps() => Check("images/mapping.svg", MappingDiagram.Create());

    [Fact]
    public void Every_field_of_every_component_has_a_tooltip()
    {
        PackageSources sources = PackageSources.Load();
        string[] types = [.. sources.Components.Select(static component => component.Type.Identifier.Text)];
        Assert.NotEmpty(types);
        Assert.Empty(types.SelectMany(type => sources.FieldsOf(type).Where(static field => string.IsNullOrWhiteSpace(field.Tooltip)).Select(field => $"{type}: {field.Name}")));
    }

    [Fact]
    public void Links_and_pictures_lead_somewhere()
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
    public void Every_page_can_be_reached_from_the_first()
    {
        string[] reached = [.. Link().Matches(File.ReadAllText(Path.Combine(Folder, "index.md"))).Select(static match => match.Groups["target"].Value.Split('#')[0]).Distinct(StringComparer.Ordinal)];
        Assert.Empty(Directory.EnumerateFiles(Folder, "*.md").Select(Path.GetFileName).Except(["index.md", .. reached]));
    }

    // NEURONMOCAP_UPDATE_DOCS=1 writes it anew.
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

    [GeneratedRegex("^#+ (?<title>.*)$", RegexOptions.Multiline | RegexOptions.ExplicitCapture, matchTimeoutMilliseconds: 1000)]
    private static partial Regex Heading();

    [GeneratedRegex("[^a-z0-9 _-]", RegexOptions.ExplicitCapture, matchTimeoutMilliseconds: 1000)]
    private static partial Regex NoAnchor();
}
