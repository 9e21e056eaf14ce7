namespace UnityEditor;

/// <summary>The project's assets, as added by tests.</summary>
public static partial class AssetDatabase
{
    private static readonly Dictionary<string, List<UnityEngine.Object>> Files = [];

    /// <summary>For tests: adds the objects of a file to the project.</summary>
    public static void Add(string path, params UnityEngine.Object[] objects) => Files[path] = [.. objects];

    public static bool Contains(UnityEngine.Object obj) => GetAssetPath(obj).Length > 0;

    public static string GetAssetPath(UnityEngine.Object? assetObject) =>
        Files.FirstOrDefault(file => file.Value.Any(item => ReferenceEquals(item, assetObject) || (assetObject is UnityEngine.Component part && ReferenceEquals(item, part.gameObject)))).Key ?? "";

    public static UnityEngine.Object[] LoadAllAssetsAtPath(string assetPath) =>
        [.. Files.TryGetValue(assetPath, out List<UnityEngine.Object>? found) ? found : Import(assetPath) ?? []];
}
