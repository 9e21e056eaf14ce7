using System.Text;
using System.Text.Json;

namespace NeuronMocap.UnityPackager;

/// <summary>The complete package in memory: all files by their paths, in order, including metas and hidden folders.</summary>
internal sealed class StagedPackage
{
    public StagedPackage(IEnumerable<KeyValuePair<string, byte[]>> files) => Files = new SortedDictionary<string, byte[]>(files.ToDictionary(), StringComparer.Ordinal);

    public IReadOnlyDictionary<string, byte[]> Files { get; }

    /// <summary>The folders that have or need metas.</summary>
    public IEnumerable<string> AssetFolders => AssetPath.FoldersOf(AssetFiles).Where(AssetPath.IsAsset).Order(StringComparer.Ordinal);

    /// <summary>The files that have or need metas.</summary>
    public IEnumerable<string> AssetFiles => Files.Keys.Where(static path => !AssetPath.IsMeta(path) && AssetPath.IsAsset(path));

    /// <summary>The version in the manifest.</summary>
    public string Version => GetManifestText("version");

    public string Name => GetManifestText("name");

    /// <summary>Loads the package's folder and the mirrored files.</summary>
    /// <exception cref="PackagerException">A file has not been built or written yet.</exception>
    public static StagedPackage Load(PackageFolder folder, string repository, string configuration)
    {
        Dictionary<string, byte[]> files = folder.Files.ToDictionary(static path => path, path => File.ReadAllBytes(folder.FullPath(path)), StringComparer.Ordinal);
        foreach (MirroredFile mirrored in MirroredFile.All)
        {
            string source = mirrored.SourceIn(repository, configuration);
            if (!File.Exists(source))
                throw new PackagerException($"{source} is missing{(mirrored.Path.StartsWith(MirroredFile.Libraries, StringComparison.Ordinal) ? ": leave out --no-build" : string.Empty)}.");

            files[mirrored.Path] = File.ReadAllBytes(source);
        }

        return new StagedPackage(files);
    }

    public string ReadText(string path) => Encoding.UTF8.GetString(Files[path]);

    /// <summary>Reads the text of an asset's meta, or returns null.</summary>
    public string? ReadMeta(string path) => Files.ContainsKey(AssetPath.MetaOf(path)) ? ReadText(AssetPath.MetaOf(path)) : null;

    private string GetManifestText(string property)
    {
        using var manifest = JsonDocument.Parse(Files["package.json"]);
        return manifest.RootElement.GetProperty(property).GetString() ?? throw new PackagerException($"package.json: {property} is null");
    }
}
