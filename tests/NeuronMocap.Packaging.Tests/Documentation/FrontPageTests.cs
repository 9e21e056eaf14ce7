using System.Text.Json;
using System.Text.RegularExpressions;
using System.Xml.Linq;
using NeuronMocap.Bvh;
using NeuronMocap.Packaging.Tests.Infrastructure;
using NeuronMocap.Recording;
using NeuronMocap.Tests.Infrastructure;

namespace NeuronMocap.Packaging.Tests.Documentation;

/// <summary>The first pages that users see: the README, the README of each package, the changelog and the sample takes.</summary>
public sealed partial class FrontPageTests
{
    private static readonly XDocument Properties = XDocument.Load(Repository.PathOf("Directory.Build.props"));

    public static TheoryData<string> PackedProjects =>
        [.. Directory.GetFiles(Repository.PathOf("src"), "*.csproj", SearchOption.AllDirectories).Select(static path => Path.GetDirectoryName(path)!).Select(static folder => Path.GetFileName(folder))];

    private static string ProjectUrl => Properties.Descendants("ProjectUrl").Single().Value;

    [Fact]
    public void The_readme_is_short_and_starts_with_the_purpose()
    {
        string[] lines = File.ReadAllLines(Repository.PathOf("README.md"));

        Assert.InRange(lines.Length, 20, 120);
        Assert.Equal("Live motion from Perception Neuron suits in .NET and Unity, over TCP or UDP.", lines[2]);
    }

    [Fact]
    public void The_changelog_has_one_entry_for_the_version_of_the_libraries()
    {
        string[] lines = File.ReadAllLines(Repository.PathOf("CHANGELOG.md"));

        Assert.InRange(lines.Length, 5, 25);
        Assert.Equal([$"## {Properties.Descendants("VersionPrefix").Single().Value}"], lines.Where(static line => line.StartsWith("## ", StringComparison.Ordinal)));
    }

    // Packing inserts the project's address before links with this start.
    [Theory, MemberData(nameof(PackedProjects))]
    public void Packing_can_complete_the_links_of_a_package_readme(string project)
    {
        string[] lines = File.ReadAllLines(Repository.PathOf("src", project, "README.md"));
        string[] targets = [.. Link().Matches(string.Join('\n', lines)).Select(static link => link.Groups["target"].Value)];

        Assert.InRange(lines.Length, 5, 60);
        Assert.NotEmpty(targets);
        Assert.All(targets, static target => Assert.StartsWith("../../", target, StringComparison.Ordinal));
    }

    [Fact]
    public void The_icon_is_128_by_128()
    {
        byte[] icon = File.ReadAllBytes(Repository.PathOf("src", "icon.png"));

        Assert.Equal("PNG"u8, icon.AsSpan(1, 3));
        Assert.Equal([0, 0, 0, 128, 0, 0, 0, 128], icon[16..24]);
    }

    [Theory, InlineData("documentationUrl"), InlineData("changelogUrl"), InlineData("licensesUrl")]
    public void The_unity_package_links_to_the_project(string property)
    {
        using var manifest = JsonDocument.Parse(ThePackage.Staged.Files["package.json"]);
        string address = manifest.RootElement.GetProperty(property).GetString()!;
        string root = $"{ProjectUrl}/blob/main/";

        Assert.StartsWith(root, address, StringComparison.Ordinal);
        Assert.True(File.Exists(Repository.PathOf(address[root.Length..].Split('/'))));
    }

    // Registries find the source of a package with these.
    [Fact]
    public void The_unity_package_names_its_author_and_repository()
    {
        using var manifest = JsonDocument.Parse(ThePackage.Staged.Files["package.json"]);
        JsonElement repository = manifest.RootElement.GetProperty("repository");

        Assert.Equal(ProjectUrl, manifest.RootElement.GetProperty("author").GetProperty("url").GetString());
        Assert.Equal("git", repository.GetProperty("type").GetString());
        Assert.Equal($"{ProjectUrl}.git", repository.GetProperty("url").GetString());
        Assert.True(File.Exists(Repository.PathOf(repository.GetProperty("directory").GetString()!, "package.json")));
    }

    [Fact]
    public void The_sample_takes_are_complete()
    {
        BvhDocument bvh = BvhDocument.Load(Repository.PathOf("samples", "takes", "walk.bvh"));
        Assert.Empty(bvh.Repairs);
        Assert.Equal((59, 120), (bvh.Joints.Count, bvh.FrameCount));

        using RecordedFrameReader take = RecordedFrameReader.Open(Repository.PathOf("samples", "takes", "walk.nmrec"));
        int frames = 0;
        while (take.Read())
            frames++;
        Assert.Equal(240, frames);
        Assert.Equal(0, Assert.Single(take.GetAvatarStatistics()).Lost);
    }

    [GeneratedRegex(@"\]\((?<target>[^)]+)\)", RegexOptions.ExplicitCapture, matchTimeoutMilliseconds: 60_000)]
    private static partial Regex Link();
}
