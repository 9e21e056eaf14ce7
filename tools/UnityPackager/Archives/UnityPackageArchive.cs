using System.Text;

namespace NeuronMocap.UnityPackager.Archives;

/// <summary>The package as an asset package. Users import it by double click or with Assets > Import Package.</summary>
/// <remarks>
/// It is a tar with a folder for each asset. The name of the folder is the GUID of the asset. It holds the asset, its meta and its path in the
/// project. Folders that the package manager hides are visible in the project: Samples~ and Documentation~ lose the '~'. The tests stay out: Unity
/// would compile them, and fail in a project without its test framework.
/// </remarks>
internal static class UnityPackageArchive
{
    public const string Root = "Assets/NeuronMocap";

    public static string NameOf(StagedPackage package) => $"NeuronMocap-{package.Version}.unitypackage";

    public static byte[] Create(StagedPackage package) => TarGz.Create(GetAssets(package).SelectMany(static asset => GetEntries(asset)));

    /// <summary>Reads the files, with their paths in a project, including metas, as Unity would write them.</summary>
    /// <exception cref="PackagerException">An asset lacks its meta or path, or the meta has another GUID than the folder.</exception>
    public static IReadOnlyDictionary<string, byte[]> Read(byte[] archive)
    {
        var files = new SortedDictionary<string, byte[]>(StringComparer.Ordinal);
        foreach (var asset in TarGz.Read(archive).GroupBy(static file => file.Key.Split('/')[0], StringComparer.Ordinal))
        {
            Dictionary<string, byte[]> parts = asset.ToDictionary(static file => AssetPath.NameOf(file.Key), static file => file.Value, StringComparer.Ordinal);
            if (!parts.TryGetValue("asset.meta", out byte[]? meta) || !parts.TryGetValue("pathname", out byte[]? path))
                throw new PackagerException($"{asset.Key} lacks its meta or its path.");
            if (MetaFile.FindGuid(Encoding.UTF8.GetString(meta)) != asset.Key)
                throw new PackagerException($"{Encoding.UTF8.GetString(path)} has another GUID in its meta than {asset.Key}.");

            files.Add(AssetPath.MetaOf(Encoding.UTF8.GetString(path)), meta);
            if (parts.TryGetValue("asset", out byte[]? content))
                files.Add(Encoding.UTF8.GetString(path), content);
        }

        return files;
    }

    /// <summary>Gets the expected result of <see cref="Read"/>.</summary>
    public static IReadOnlyDictionary<string, byte[]> FilesOf(StagedPackage package)
    {
        var files = new SortedDictionary<string, byte[]>(StringComparer.Ordinal);
        foreach (Asset asset in GetAssets(package))
        {
            files.Add(AssetPath.MetaOf(asset.Path), Encoding.UTF8.GetBytes(asset.Meta));
            if (asset.Content is not null)
                files.Add(asset.Path, asset.Content);
        }

        return files;
    }

    private static IEnumerable<Asset> GetAssets(StagedPackage package)
    {
        List<string> files = [.. package.Files.Keys.Where(static path => !AssetPath.IsMeta(path) && !AssetPath.IsTest(path))];
        IEnumerable<Asset> folders = AssetPath.FoldersOf(files).Select(path => CreateAsset(package, path, content: null));
        return folders
            .Concat(files.Select(path => CreateAsset(package, path, package.Files[path])))
            .Append(new Asset(Root, MetaFile.Create(Root, isFolder: true, MetaFile.DeriveGuid(Root)), Content: null))
            .OrderBy(static asset => asset.Path, StringComparer.Ordinal);
    }

    // Documents, and folders that lose their '~', have no meta in the package.
    private static Asset CreateAsset(StagedPackage package, string path, byte[]? content)
    {
        string visible = $"{Root}/{MakeVisible(path)}";
        string meta = package.ReadMeta(path) ?? MetaFile.Create(visible, isFolder: content is null, MetaFile.DeriveGuid(visible));
        return new Asset(visible, meta, content is not null && path.EndsWith(".md", StringComparison.Ordinal) ? WithVisibleLinks(content) : content);
    }

    private static byte[] WithVisibleLinks(byte[] page) =>
        Encoding.UTF8.GetBytes(Encoding.UTF8.GetString(page).Replace($"]({AssetPath.Documentation}/", "](Documentation/", StringComparison.Ordinal));

    private static string MakeVisible(string path) => string.Join('/', path.Split('/').Select(static name => name.TrimEnd('~')));

    private static IEnumerable<(string Name, byte[]? Content)> GetEntries(Asset asset)
    {
        string guid = MetaFile.FindGuid(asset.Meta) ?? throw new PackagerException($"The meta of {asset.Path} has no GUID.");
        yield return ($"{guid}/", null);
        if (asset.Content is not null)
            yield return ($"{guid}/asset", asset.Content);

        yield return ($"{guid}/asset.meta", Encoding.UTF8.GetBytes(asset.Meta));
        yield return ($"{guid}/pathname", Encoding.UTF8.GetBytes(asset.Path));
    }

    private sealed record Asset(string Path, string Meta, byte[]? Content);
}
