namespace NeuronMocap.UnityPackager;

/// <summary>Paths inside the package. They are relative, with '/', and their names have a meaning for Unity.</summary>
internal static class AssetPath
{
    public const string MetaExtension = ".meta";
    public const string Samples = "Samples~";
    public const string Documentation = "Documentation~";

    public static bool IsMeta(string path) => path.EndsWith(MetaExtension, StringComparison.Ordinal);

    public static string MetaOf(string path) => path + MetaExtension;

    public static string AssetOf(string metaPath) => metaPath[..^MetaExtension.Length];

    public static string NameOf(string path) => path[(path.LastIndexOf('/') + 1)..];

    public static string? ParentOf(string path) => path.LastIndexOf('/') is var slash and >= 0 ? path[..slash] : null;

    /// <summary>Whether a file belongs to the package.</summary>
    public static bool IsPacked(string path) => !path.Split('/').Any(static name => name.StartsWith('.'));

    /// <summary>Whether a file or folder has a meta.</summary>
    /// <remarks>
    /// Unity ignores folders whose names end in '~'. It copies the folders of samples into a project, where their files are ordinary assets.
    /// </remarks>
    public static bool IsAsset(string path) => path != Samples && path != Documentation && !path.StartsWith(Documentation + '/', StringComparison.Ordinal);

    /// <summary>Whether a file belongs to the tests of the package.</summary>
    public static bool IsTest(string path) => path.StartsWith("Tests/", StringComparison.Ordinal);

    /// <summary>Gets the folders above some files, each once.</summary>
    public static IEnumerable<string> FoldersOf(IEnumerable<string> files) => files.SelectMany(AncestorsOf).Distinct(StringComparer.Ordinal);

    private static IEnumerable<string> AncestorsOf(string path)
    {
        for (string? parent = ParentOf(path); parent is not null; parent = ParentOf(parent))
            yield return parent;
    }
}
