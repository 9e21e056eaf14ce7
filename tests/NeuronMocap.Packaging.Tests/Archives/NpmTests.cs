using System.Text.Json;
using System.Text.Json.Nodes;
using NeuronMocap.Packaging.Tests.Infrastructure;
using NeuronMocap.Tests.Infrastructure;
using NeuronMocap.UnityPackager.Archives;

namespace NeuronMocap.Packaging.Tests.Archives;

// Unity's package manager and package registries accept what npm accepts.
public sealed class NpmTests
{
    [Fact]
    public async Task Npm_installs_the_tarball_with_every_file()
    {
        Assert.SkipUnless(InstalledPrograms.Have("npm"), "npm is not installed.");
        using var folder = new TemporaryFolder();
        folder.Write("package.json", CreateProject(folder));
        string tarball = folder.PathOf(UpmTarball.NameOf(ThePackage.Staged));
        await File.WriteAllBytesAsync(tarball, ThePackage.Tarball, TestContext.Current.CancellationToken);

        await Tool.RunAsync(
            folder.Path, "npm", "install", "--offline", "--no-audit", "--no-fund", "--ignore-scripts", "--cache", folder.PathOf("cache"), tarball);

        string installed = folder.PathOf("node_modules", ThePackage.Staged.Name);
        Assert.All(ThePackage.Staged.Files, file => Assert.Equal(file.Value, File.ReadAllBytes(Path.Combine(installed, file.Key))));
    }

    // Unity provides the modules that the package depends on, and no registry has them. Stand-ins keep npm from searching online.
    private static string CreateProject(TemporaryFolder folder)
    {
        using var manifest = JsonDocument.Parse(ThePackage.Staged.Files["package.json"]);
        var overrides = new JsonObject();
        foreach (JsonProperty dependency in manifest.RootElement.GetProperty("dependencies").EnumerateObject())
        {
            folder.Write($"modules/{dependency.Name}/package.json", $$"""{ "name": "{{dependency.Name}}", "version": "{{dependency.Value.GetString()}}" }""");
            overrides[dependency.Name] = $"file:modules/{dependency.Name}";
        }

        return new JsonObject { ["name"] = "project", ["version"] = "1.0.0", ["private"] = true, ["overrides"] = overrides }.ToJsonString();
    }
}
