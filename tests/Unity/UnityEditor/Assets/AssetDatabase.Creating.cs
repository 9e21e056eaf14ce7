namespace UnityEditor;

// Files and folders created by scripts.
public static partial class AssetDatabase
{
    private static readonly HashSet<string> Folders = ["Assets"];

    public static bool IsValidFolder(string path) => Folders.Contains(path);

    /// <returns>A GUID, or an empty string if the parent does not exist.</returns>
    public static string CreateFolder(string parentFolder, string newFolderName)
    {
        if (!Folders.Contains(parentFolder) || newFolderName.Contains('/', StringComparison.Ordinal))
            return "";

        Folders.Add($"{parentFolder}/{newFolderName}");
        return Guid.NewGuid().ToString("N");
    }

    public static void CreateAsset(UnityEngine.Object asset, string path)
    {
        string folder = Path.GetDirectoryName(path)?.Replace('\\', '/') ?? "";
        if (!Folders.Contains(folder))
            throw new UnityEngine.UnityException($"Creating asset at path {path} failed: the folder is not there.");

        asset.name = Path.GetFileNameWithoutExtension(path);
        Add(path, asset);
    }

    public static string GenerateUniqueAssetPath(string path)
    {
        string unique = path;
        for (int number = 1; Files.ContainsKey(unique); number++)
            unique = $"{path[..^Path.GetExtension(path).Length]} {number}{Path.GetExtension(path)}";

        return unique;
    }

    public static T? LoadAssetAtPath<T>(string assetPath)
        where T : UnityEngine.Object => LoadAllAssetsAtPath(assetPath).OfType<T>().FirstOrDefault();

    public static void SaveAssets()
    {
    }

    public static void Refresh()
    {
    }
}
