using NeuronMocap.Packaging.Tests.Infrastructure;
using NeuronMocap.Tests.Infrastructure;
using NeuronMocap.UnityPackager;

namespace NeuronMocap.Packaging.Tests;

// The other ways into a project: a branch, a project's own folder, a clone.
public sealed class DeliveryTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public async Task A_branch_holds_the_package_and_the_work_tree_is_unchanged()
    {
        string head = await CreateRepositoryAsync();
        var git = new GitBranch(_folder.Path);

        (string first, bool isNew) = git.Commit(ThePackage.Staged, "upm");

        Assert.True(isNew);
        Assert.Equal(first, await GitAsync("rev-parse", "upm"));
        Assert.Equal(ThePackage.Staged.Files.Keys.Select(static path => $"unity-package/{path}"), (await GitAsync("ls-tree", "-r", "--name-only", "upm")).Split('\n').Order(StringComparer.Ordinal));
        Assert.Contains(head, await GitAsync("log", "-1", "--format=%s", "upm"), StringComparison.Ordinal);
        Assert.Equal(head, await GitAsync("rev-parse", "HEAD"));
        Assert.Empty(await GitAsync("status", "--porcelain"));
    }

    [Fact]
    public async Task The_branch_grows_only_when_the_package_changes()
    {
        await CreateRepositoryAsync();
        var git = new GitBranch(_folder.Path);
        (string first, _) = git.Commit(ThePackage.Staged, "upm");

        Assert.Equal((first, false), git.Commit(ThePackage.Staged, "upm"));
        (string second, bool isNew) = git.Commit(ThePackage.With(static files => files.Remove("README.md")), "upm");

        Assert.True(isNew);
        Assert.Equal(first, await GitAsync("rev-parse", $"{second}^"));
        Assert.Equal("D\tunity-package/README.md", await GitAsync("diff", "--name-status", first, second));
    }

    [Fact]
    public async Task A_checked_out_branch_is_byte_for_byte_the_package()
    {
        await CreateRepositoryAsync();
        new GitBranch(_folder.Path).Commit(ThePackage.Staged, "upm");

        await GitAsync("checkout", "--quiet", "upm");

        Assert.All(ThePackage.Staged.Files, file => Assert.Equal(file.Value, File.ReadAllBytes(_folder.PathOf("unity-package", file.Key))));
    }

    [Fact]
    public async Task An_invalid_branch_name_is_refused()
    {
        await CreateRepositoryAsync();
        var exception = Assert.Throws<PackagerException>(() => new GitBranch(_folder.Path).Commit(ThePackage.Staged, "a..b"));
        Assert.Contains("a..b", exception.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Installing_replaces_an_older_package_in_a_project()
    {
        Directory.CreateDirectory(_folder.PathOf("Assets"));
        _folder.Write("Packages/manifest.json", "{}");
        _folder.Write("Packages/org.neuronmocap.unity/Old.cs", "");

        string target = PackageInstaller.InstallInto(_folder.Path, ThePackage.Staged);

        Assert.Equal(_folder.PathOf("Packages", "org.neuronmocap.unity"), target);
        Assert.Equal(
            ThePackage.Staged.Files.Keys,
            Directory.EnumerateFiles(target, "*", SearchOption.AllDirectories).Select(file => Path.GetRelativePath(target, file).Replace('\\', '/')).Order(StringComparer.Ordinal));
        Assert.Equal("{}", File.ReadAllText(_folder.PathOf("Packages", "manifest.json")));
    }

    [Fact]
    public void Folders_without_a_project_are_left_alone()
    {
        Assert.Throws<PackagerException>(() => PackageInstaller.InstallInto(_folder.Path, ThePackage.Staged));
        Assert.Empty(Directory.EnumerateFileSystemEntries(_folder.Path));
    }

    [Fact]
    public void A_clone_is_completed_in_place()
    {
        PackageInstaller.CompleteInPlace(_folder.Path, ThePackage.Staged);

        Assert.Equal(
            MirroredFile.All.Select(static file => file.Path).Order(StringComparer.Ordinal),
            Directory.EnumerateFiles(_folder.Path, "*", SearchOption.AllDirectories).Select(file => Path.GetRelativePath(_folder.Path, file).Replace('\\', '/')).Order(StringComparer.Ordinal));
    }

    private async Task<string> CreateRepositoryAsync()
    {
        Assert.SkipUnless(InstalledPrograms.Have("git"), "git is not installed.");
        await GitAsync("init", "--quiet");
        await GitAsync("config", "user.name", "Test");
        await GitAsync("config", "user.email", "test@localhost");
        await GitAsync("config", "commit.gpgsign", "false");

        // As on Windows. The contents must not change in transit.
        await GitAsync("config", "core.autocrlf", "input");
        _folder.Write("source.txt", "text");
        await GitAsync("add", "source.txt");
        await GitAsync("commit", "--quiet", "-m", "Source");
        return await GitAsync("rev-parse", "HEAD");
    }

    private Task<string> GitAsync(params string[] arguments) => Tool.RunAsync(_folder.Path, "git", arguments);
}
