using System.Text.Json;
using System.Xml.Linq;
using NeuronMocap.Packaging.Tests.Infrastructure;
using NeuronMocap.Tests.Infrastructure;
using NeuronMocap.UnityPackager;
using NeuronMocap.UnityPackager.Checks;

namespace NeuronMocap.Packaging.Tests;

public sealed class PackageTests
{
    [Fact]
    public void The_package_is_valid() => Assert.Empty(PackageLint.Check(ThePackage.Staged));

    [Fact]
    public void Every_file_has_a_committed_meta() => Assert.Empty(new PackageFolder(ThePackage.Folder).OrphanMetas);

    [Fact]
    public void The_package_has_the_libraries_version()
    {
        var properties = XDocument.Load(Repository.PathOf("Directory.Build.props"));
        Assert.Equal(properties.Descendants("VersionPrefix").Single().Value, ThePackage.Staged.Version);
    }

    [Fact]
    public void The_changelog_and_licence_match_the_repository()
    {
        Assert.Equal(File.ReadAllText(Repository.PathOf("CHANGELOG.md")), ThePackage.Staged.ReadText("CHANGELOG.md"));
        Assert.Equal(File.ReadAllText(Repository.PathOf("LICENSE")), ThePackage.Staged.ReadText("LICENSE.md"));
    }

    [Fact]
    public void All_samples_are_listed()
    {
        using var manifest = JsonDocument.Parse(ThePackage.Staged.Files["package.json"]);
        Assert.Equal(
            ["QuickStart", "ManyPerformers", "VrHead", "RecordAndPlayBack", "Scripting", "TwoSources", "Timeline", "Physics", "Smoothing", "VendorComponents"],
            manifest.RootElement.GetProperty("samples").EnumerateArray().Select(static sample => AssetPath.NameOf(sample.GetProperty("path").GetString()!)));
    }

    [Fact]
    public void Hidden_files_are_not_in_the_package() =>
        Assert.DoesNotContain(ThePackage.Staged.Files.Keys, static path => path.Split('/').Any(static name => name.StartsWith('.')));
}
