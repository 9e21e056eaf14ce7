using System.Text.RegularExpressions;
using NeuronMocap.Packaging.Tests.Infrastructure;
using NeuronMocap.Tests.Infrastructure;
using NeuronMocap.UnityPackager;

namespace NeuronMocap.Packaging.Tests.Documentation;

/// <summary>The help button and the icon of every component in the menu.</summary>
public sealed partial class ComponentHelpTests
{
    [Fact]
    public void Every_component_has_a_help_page_with_its_heading()
    {
        string page = File.ReadAllText(Repository.PathOf("unity-package", "Documentation~", "components.md"));
        Assert.NotEmpty(PackageSources.All.Components);
        Assert.All(PackageSources.All.Components, component =>
        {
            string anchor = component.Menu.ToLowerInvariant().Replace(' ', '-');
            Assert.Contains($"[HelpURL(HelpPage.Components + \"#{anchor}\")]", component.Type.AttributeLists.ToString(), StringComparison.Ordinal);
            Assert.Contains($"\n## {component.Menu}\n", page, StringComparison.Ordinal);
        });
    }

    [Fact]
    public void The_help_page_is_a_file_of_the_project()
    {
        string page = Help().Match(File.ReadAllText(Repository.PathOf("unity-package", "Runtime", "HelpPage.cs"))).Groups["url"].Value;
        string manifest = ThePackage.Staged.ReadText("package.json");
        string root = DocumentationUrl().Match(manifest).Groups["root"].Value;
        Assert.StartsWith(root, page, StringComparison.Ordinal);
        Assert.True(File.Exists(Repository.PathOf(page[root.Length..].Split('/'))), page);
    }

    [Fact]
    public void Every_component_has_an_icon_of_the_package()
    {
        HashSet<string> pictures = [.. ThePackage.Staged.AssetFiles
            .Where(static path => path.EndsWith(".png", StringComparison.Ordinal))
            .Select(static path => MetaFile.FindGuid(ThePackage.Staged.ReadMeta(path)!)!)];
        Assert.All(PackageSources.All.Components, component =>
        {
            string name = component.Type.Identifier.Text;
            string source = Assert.Single(ThePackage.Staged.AssetFiles, path => AssetPath.NameOf(path) == $"{name}.cs");
            string icon = Icon().Match(ThePackage.Staged.ReadMeta(source)!).Groups["guid"].Value;
            Assert.True(pictures.Contains(icon), $"{name} has no icon: name the GUID of a picture in {source}.meta.");
        });
    }

    [GeneratedRegex("\"(?<url>https:[^\"]+)\"", RegexOptions.ExplicitCapture, matchTimeoutMilliseconds: 60_000)]
    private static partial Regex Help();

    [GeneratedRegex("\"documentationUrl\": \"(?<root>.*/blob/main/)", RegexOptions.ExplicitCapture, matchTimeoutMilliseconds: 60_000)]
    private static partial Regex DocumentationUrl();

    [GeneratedRegex(@"icon: \{fileID: 2800000, guid: (?<guid>[0-9a-f]{32}), type: 3\}", RegexOptions.ExplicitCapture, matchTimeoutMilliseconds: 60_000)]
    private static partial Regex Icon();
}
