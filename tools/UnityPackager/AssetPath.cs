namespace NeuronMocap.UnityPackager;

/// <summary>Paths inside the package: relative, with '/', and what Unity makes of their names.</summary>
internal static class AssetPath
{
    public const string MetaExtension = ".meta";
    public const string Samples = "Samples~";
    public const string Documentation = "Documentation~";

    // The script that calls this program lies in the package's folder, and is no part of it.
    private const string Script = "pack";

    public static bool IsMeta(string path) => path.EndsWith(MetaExtension, StringComparison.Ordinal);

    public static string MetaOf(string path) => path + MetaExtension;

    public static string AssetOf(string metaPath) => metaPath[..^MetaExtension.Length];

    public static string NameOf(string path) => path[(path.LastIndexOf('/') + 1)..];

    public static string? ParentOf(string path) => path.LastIndexOf('/') is var slash and >= 0 ? path[..slash] : null;

    /// <summary>Whether a file belongs into the package at all.</summary>
    public static bool IsPacked(string path) => path != Script && path != MetaOf(Script) && !path.Split('/').Any(static name => name.StartsWith('.'));

    /// <summary>
    /// Whether a file or folder has a meta. Unity does not look into folders whose names end in '~', but copies those of samples into a project, where
    /// their files are assets as any other.
    /// </summary>
    public static bool IsAsset(string path) => path != Samples && path != Documentation && !path.StartsWith(Documentation + '/', StringComparison.Ordinal);

    /// <summary>The folders above some files, each once.</summary>
    public static IEnumerable<string> FoldersOf(IEnumerable<string> files) => files.SelectMany(AncestorsOf).Distinct(StringComparer.Ordinal);

    private static IEnumerable<string> AncestorsOf(string path)
    {
        for (string? parent = ParentOf(path); parent is not null; parent = ParentOf(parent))
            yield return parent;
    }
}
