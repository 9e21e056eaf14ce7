using System.Text;
using System.Text.RegularExpressions;
using NeuronMocap.Packaging.Tests.Infrastructure;
using NeuronMocap.Tests.Infrastructure;
using NeuronMocap.UnityPackager;
using NeuronMocap.UnityPackager.Archives;
using NeuronMocap.UnityPackager.Checks;

namespace NeuronMocap.Packaging.Tests.Archives;

public sealed partial class ArchiveTests
{
    private static readonly IReadOnlyDictionary<string, byte[]> OpenedAssets = UnityPackageArchive.Read(ThePackage.AssetPackage);

    [Fact]
    public void The_tarball_holds_the_valid_package()
    {
        StagedPackage opened = UpmTarball.Read(ThePackage.Tarball);

        Assert.Equal(ThePackage.Staged.Files, opened.Files);
        Assert.Empty(PackageLint.Check(opened));
        Assert.Equal($"org.neuronmocap.unity-{ThePackage.Staged.Version}.tgz", UpmTarball.NameOf(opened));
    }

    [Fact]
    public void The_asset_package_holds_the_same_files_without_the_tests()
    {
        IReadOnlyDictionary<string, byte[]> opened = OpenedAssets;

        foreach ((string path, byte[] content) in ThePackage.Staged.Files.Where(static file => !file.Key.EndsWith(".md", StringComparison.Ordinal) && !file.Key.StartsWith("Tests", StringComparison.Ordinal)))
            Assert.Equal(content, opened[$"Assets/NeuronMocap/{path.Replace("~", "", StringComparison.Ordinal)}"]);

        Assert.DoesNotContain(opened.Keys, static path => path.Contains("/Tests", StringComparison.Ordinal));

        // Unity needs a meta file for everything that it imports. Only those for files hidden in the other archive are added.
        string[] added = [.. opened.Keys.Except(ThePackage.Staged.Files.Keys.Select(static path => $"Assets/NeuronMocap/{path.Replace("~", "", StringComparison.Ordinal)}"))];
        Assert.Contains("Assets/NeuronMocap.meta", added);
        Assert.Contains("Assets/NeuronMocap/Samples.meta", added);
        Assert.Contains("Assets/NeuronMocap/Documentation/index.md.meta", added);
        Assert.All(added, static path => Assert.EndsWith(".meta", path, StringComparison.Ordinal));
    }

    [Fact]
    public void Pages_of_the_asset_package_link_to_its_own_files()
    {
        IReadOnlyDictionary<string, byte[]> opened = OpenedAssets;
        string[] links = [.. opened
            .Where(static file => file.Key.EndsWith(".md", StringComparison.Ordinal) && !file.Key.EndsWith("CHANGELOG.md", StringComparison.Ordinal))
            .SelectMany(static page => Link().Matches(Encoding.UTF8.GetString(page.Value)).Select(link => Resolve(page.Key, link.Groups["target"].Value)))];

        Assert.True(links.Length > 10);
        Assert.Contains("Assets/NeuronMocap/Documentation/index.md", links);
        Assert.DoesNotContain(links, link => !opened.ContainsKey(link));

        static string Resolve(string page, string target) => Path.GetRelativePath("/", Path.GetFullPath(Path.Combine("/", AssetPath.ParentOf(page)!, target))).Replace('\\', '/');
    }

    [Fact]
    public void Every_asset_has_a_meta_and_a_unique_guid()
    {
        IReadOnlyDictionary<string, byte[]> opened = OpenedAssets;
        string[] assets = [.. opened.Keys.Where(static path => !AssetPath.IsMeta(path))];
        string[] wanted = [.. assets.Concat(AssetPath.FoldersOf(assets)).Where(static path => path != "Assets").Distinct().Order(StringComparer.Ordinal)];

        Assert.Equal(wanted, opened.Keys.Where(AssetPath.IsMeta).Select(AssetPath.AssetOf).Order(StringComparer.Ordinal));
        Assert.Equal(wanted.Length, opened.Where(static file => AssetPath.IsMeta(file.Key)).Select(static file => MetaFile.FindGuid(Encoding.UTF8.GetString(file.Value))).Distinct().Count());
    }

    [Fact]
    public void Nothing_in_the_asset_package_is_hidden_from_Unity() => Assert.DoesNotContain(
        OpenedAssets.Keys,
        static path => path.Split('/').Any(static name => name.EndsWith('~') || name.StartsWith('.')));

    [Fact]
    public void Packing_is_deterministic()
    {
        StagedPackage again = ThePackage.With(static _ => { });
        Assert.True(ThePackage.Tarball.AsSpan().SequenceEqual(UpmTarball.Create(again)));
        Assert.True(ThePackage.AssetPackage.AsSpan().SequenceEqual(UnityPackageArchive.Create(again)));
    }

    // Opening an archive detects a changed byte, a missing meta file and a file in the wrong place.
    [Fact]
    public void A_broken_archive_is_refused()
    {
        Assert.Throws<PackagerException>(() => UpmTarball.Read(TarGz.Create([("other/package.json", [1])])));
        Assert.Throws<PackagerException>(() => UpmTarball.Read(TarGz.Create([("package/a", [1]), ("package/a", [2])])));
        Assert.Throws<PackagerException>(() => UnityPackageArchive.Read(TarGz.Create([("0123/asset", [1])])));
        byte[] meta = Encoding.UTF8.GetBytes(MetaFile.Create("a", isFolder: false, MetaFile.DeriveGuid("a")));
        Assert.Throws<PackagerException>(() => UnityPackageArchive.Read(TarGz.Create([("0123/asset.meta", meta), ("0123/pathname", [65])])));
    }

    [Fact]
    public async Task The_system_tar_reads_both()
    {
        Assert.SkipUnless(InstalledPrograms.Have("tar"), "There is no tar.");
        using var folder = new TemporaryFolder();
        foreach ((byte[] archive, int files) in new[] { (ThePackage.Tarball, ThePackage.Staged.Files.Count), (ThePackage.AssetPackage, 0) })
        {
            await File.WriteAllBytesAsync(folder.PathOf("archive"), archive, TestContext.Current.CancellationToken);
            string listing = await Tool.RunAsync(folder.Path, "tar", "-tvzf", "archive");
            string[] lines = listing.Split('\n');
            if (files > 0)
                Assert.Equal(files, lines.Length);

            Assert.All(lines, static line => Assert.Matches("^[-d]rw[-x]r-[-x]r-[-x] 0/0 ", line));
        }
    }

    [GeneratedRegex(@"\]\((?<target>[^)#:]+)(#[^)]*)?\)", RegexOptions.ExplicitCapture, matchTimeoutMilliseconds: 1000)]
    private static partial Regex Link();
}
