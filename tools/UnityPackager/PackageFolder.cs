namespace NeuronMocap.UnityPackager;

/// <summary>The folder unity-package of the repository: its files, and the metas of all its assets.</summary>
internal sealed class PackageFolder
{
    private readonly string _root;

    public PackageFolder(string root)
    {
        _root = root;
        Files = [.. Directory.EnumerateFiles(root, "*", SearchOption.AllDirectories)
            .Select(file => Path.GetRelativePath(root, file).Replace(Path.DirectorySeparatorChar, '/'))
            .Where(AssetPath.IsPacked)
            .Order(StringComparer.Ordinal)];
        IEnumerable<string> assets = Files.Where(static file => !AssetPath.IsMeta(file)).Union(MirroredFile.All.Select(static file => file.Path), StringComparer.Ordinal);
        AssetFiles = [.. assets.Where(AssetPath.IsAsset).Order(StringComparer.Ordinal)];
        AssetFolders = [.. AssetPath.FoldersOf(AssetFiles).Where(AssetPath.IsAsset).Order(StringComparer.Ordinal)];
    }

    /// <summary>All files, including metas and hidden folders.</summary>
    public IReadOnlyList<string> Files { get; }

    /// <summary>The files that have a meta, including mirrored files, whether or not they exist.</summary>
    public IReadOnlyList<string> AssetFiles { get; }

    /// <summary>The folders that have a meta.</summary>
    public IReadOnlyList<string> AssetFolders { get; }

    /// <summary>Metas of files and folders that do not exist.</summary>
    public IEnumerable<string> OrphanMetas =>
        Files.Where(AssetPath.IsMeta).Where(meta => !AssetFiles.Concat(AssetFolders).Contains(AssetPath.AssetOf(meta), StringComparer.Ordinal));

    public string FullPath(string path) => Path.Combine(_root, path);

    /// <summary>Writes missing metas. Existing metas do not change, even if they were edited or moved with their files.</summary>
    /// <returns>The paths of the new metas.</returns>
    public IReadOnlyList<string> AddMissingMetas()
    {
        HashSet<string> guids = [.. Files.Where(AssetPath.IsMeta).Select(ReadGuid).OfType<string>()];
        List<string> added = [];
        foreach (string path in AssetFolders.Concat(AssetFiles).Where(path => !File.Exists(FullPath(AssetPath.MetaOf(path)))))
        {
            string guid = ChooseGuid(path, guids);
            string meta = FullPath(AssetPath.MetaOf(path));
            Directory.CreateDirectory(Path.GetDirectoryName(meta)!);
            File.WriteAllText(meta, MetaFile.Create(path, AssetFolders.Contains(path), guid));
            added.Add(AssetPath.MetaOf(path));
        }

        return added;
    }

    /// <summary>Gets the GUID of an asset: that of its meta, or the one that a new meta would get.</summary>
    public string GuidOf(string path) => ReadGuid(AssetPath.MetaOf(path)) ?? MetaFile.DeriveGuid(path);

    private string? ReadGuid(string meta) => File.Exists(FullPath(meta)) ? MetaFile.FindGuid(File.ReadAllText(FullPath(meta))) : null;

    // A new file at the path of a moved file must not get the GUID of the moved file.
    private static string ChooseGuid(string path, HashSet<string> taken)
    {
        string guid = MetaFile.DeriveGuid(path);
        for (int number = 2; !taken.Add(guid); number++)
            guid = MetaFile.DeriveGuid($"{path}#{number}");

        return guid;
    }
}
