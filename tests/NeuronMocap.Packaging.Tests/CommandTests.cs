using NeuronMocap.Packaging.Tests.Infrastructure;
using NeuronMocap.Tests.Infrastructure;
using NeuronMocap.UnityPackager;
using NeuronMocap.UnityPackager.Archives;

namespace NeuronMocap.Packaging.Tests;

public sealed class CommandTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public async Task Both_archives_are_written_and_named()
    {
        (int code, string output, string error) = await RunAsync("--no-build", "--configuration", ThePackage.Configuration, "--repository", Repository.Root, "--output", _folder.Path);

        Assert.Equal((0, string.Empty), (code, error));
        Assert.Equal(
            [_folder.PathOf(UpmTarball.NameOf(ThePackage.Staged)), _folder.PathOf(UnityPackageArchive.NameOf(ThePackage.Staged))],
            output.Split('\n', StringSplitOptions.RemoveEmptyEntries));
        Assert.Equal(ThePackage.Tarball, File.ReadAllBytes(_folder.PathOf(UpmTarball.NameOf(ThePackage.Staged))));
        Assert.Equal(ThePackage.AssetPackage, File.ReadAllBytes(_folder.PathOf(UnityPackageArchive.NameOf(ThePackage.Staged))));
    }

    [Fact]
    public async Task A_guid_is_printed_for_scenes()
    {
        (int code, string output, _) = await RunAsync("--repository", Repository.Root, "--guid", "Compatibility/ScriptSession.cs");
        Assert.Equal((0, MetaFile.DeriveGuid("Compatibility/ScriptSession.cs")), (code, output.Trim()));
    }

    [Fact]
    public async Task Libraries_that_were_not_built_are_named()
    {
        _folder.Write("unity-package/package.json", "{}");
        _folder.Write("CHANGELOG.md", "");
        _folder.Write("LICENSE", "");
        (int code, _, string error) = await RunAsync("--no-build", "--repository", _folder.Path);
        Assert.Equal(1, code);
        Assert.Contains("NeuronMocap.dll is missing: leave out --no-build", error, StringComparison.Ordinal);
    }

    [Fact]
    public async Task Libraries_that_do_not_build_are_named()
    {
        _folder.Write("unity-package/package.json", "{}");
        (int code, _, string error) = await RunAsync();
        Assert.Equal(1, code);
        Assert.Contains("NeuronMocap.Compatibility does not build:", error, StringComparison.Ordinal);
    }

    [Fact]
    public async Task Outside_the_repository_the_error_names_the_option()
    {
        (int code, _, string error) = await RunAsync("--metas");
        Assert.Equal((1, "No folder unity-package is here or above; name the root of the repository with --repository."), (code, error.Trim()));
    }

    [Fact]
    public async Task Help_succeeds_and_an_unknown_option_fails()
    {
        (int code, string output, _) = await RunAsync("--help");
        Assert.Equal(0, code);
        Assert.Contains("--install", output, StringComparison.Ordinal);
        (code, _, string error) = await RunAsync("--nonsense");
        Assert.Equal(2, code);
        Assert.Contains("--nonsense", error, StringComparison.Ordinal);
    }

    private Task<(int Code, string Output, string Error)> RunAsync(params string[] arguments) =>
        Tool.TryRunAsync(_folder.Path, "dotnet", [typeof(PackageFolder).Assembly.Location, .. arguments]);
}
