using NeuronMocap.Packaging.Tests.Infrastructure;
using NeuronMocap.UnityPackager;

namespace NeuronMocap.Packaging.Tests;

public sealed class MetaTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void A_guid_is_derived_from_the_path()
    {
        Assert.Equal("a9a344d53627369fd5bb2b430564bc7c", MetaFile.DeriveGuid("Runtime/NeuronMocap.Unity.asmdef"));
        Assert.NotEqual(MetaFile.DeriveGuid("A.cs"), MetaFile.DeriveGuid("a.cs"));
    }

    [Fact]
    public void Files_folders_and_unbuilt_libraries_get_a_meta()
    {
        _folder.Write("Runtime/A.cs", "");
        _folder.Write("Samples~/One/One.unity", "");
        _folder.Write("Documentation~/index.md", "");
        _folder.Write(".gitignore", "");

        IReadOnlyList<string> added = new PackageFolder(_folder.Path).AddMissingMetas();

        Assert.Equal(
            ["Runtime.meta", "Runtime/A.cs.meta", "Runtime/Libraries.meta", "Samples~/One.meta", "Samples~/One/One.unity.meta"],
            added.Where(static meta => !MirroredFile.All.Any(file => meta == $"{file.Path}.meta")).Order(StringComparer.Ordinal));
        Assert.All(MirroredFile.All, file => Assert.Contains($"{file.Path}.meta", added));
        Assert.All(added, meta => Assert.Equal(MetaFile.DeriveGuid(AssetPath.AssetOf(meta)), GuidIn(meta)));
        Assert.Empty(new PackageFolder(_folder.Path).AddMissingMetas());
    }

    [Fact]
    public void A_moved_file_keeps_its_guid_and_its_replacement_gets_a_new_one()
    {
        _folder.Write("Runtime/A.cs", "");
        new PackageFolder(_folder.Path).AddMissingMetas();
        string guid = GuidIn("Runtime/A.cs.meta");

        File.Move(_folder.PathOf("Runtime/A.cs"), _folder.PathOf("Runtime/B.cs"));
        File.Move(_folder.PathOf("Runtime/A.cs.meta"), _folder.PathOf("Runtime/B.cs.meta"));
        _folder.Write("Runtime/A.cs", "");
        Assert.Equal(["Runtime/A.cs.meta"], new PackageFolder(_folder.Path).AddMissingMetas());

        Assert.Equal(guid, GuidIn("Runtime/B.cs.meta"));
        Assert.Equal(guid, new PackageFolder(_folder.Path).GuidOf("Runtime/B.cs"));
        Assert.NotEqual(guid, GuidIn("Runtime/A.cs.meta"));
    }

    [Fact]
    public void Edited_metas_are_kept_and_missing_ones_are_found()
    {
        _folder.Write("Runtime/A.cs", "");
        _folder.Write("Runtime/A.cs.meta", "fileFormatVersion: 2\nguid: 0123456789abcdef0123456789abcdef\nMonoImporter:\n  executionOrder: -5\n");
        _folder.Write("Runtime/Gone.cs.meta", "");

        var folder = new PackageFolder(_folder.Path);
        folder.AddMissingMetas();

        Assert.Equal("0123456789abcdef0123456789abcdef", GuidIn("Runtime/A.cs.meta"));
        Assert.Equal(["Runtime/Gone.cs.meta"], folder.OrphanMetas);
    }

    [Theory]
    [InlineData("A.cs", "MonoImporter")]
    [InlineData("A.dll", "PluginImporter")]
    [InlineData("A.asmdef", "AssemblyDefinitionImporter")]
    [InlineData("package.json", "PackageManifestImporter")]
    [InlineData("Samples~/One/settings.json", "TextScriptImporter")]
    [InlineData("README.md", "TextScriptImporter")]
    [InlineData("A.unity", "DefaultImporter")]
    [InlineData("A.pdb", "DefaultImporter")]
    [InlineData("A.png", "TextureImporter")]
    [InlineData("A.mat", "NativeFormatImporter")]
    public void Each_kind_of_file_has_its_importer(string path, string importer) =>
        Assert.Equal(importer, MetaFile.FindImporter(MetaFile.Create(path, isFolder: false, "0")));

    [Fact]
    public void A_library_targets_every_platform_with_automatic_references()
    {
        string meta = MetaFile.Create("A.dll", isFolder: false, "0");
        Assert.Contains("      Any: \n    second:\n      enabled: 1\n", meta, StringComparison.Ordinal);
        Assert.Contains("  isExplicitlyReferenced: 0\n  validateReferences: 1\n", meta, StringComparison.Ordinal);
        Assert.Contains("  defineConstraints: []\n", meta, StringComparison.Ordinal);
    }

    private string GuidIn(string meta) => MetaFile.FindGuid(File.ReadAllText(_folder.PathOf(meta)))!;
}
