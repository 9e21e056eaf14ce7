using UnityEngine;

namespace UnityEditor;

// The project's files: their GUIDs, and scenes and prefabs as text below Application.dataPath.
public static partial class AssetDatabase
{
    private static readonly Dictionary<string, string> PathsByGuid = [];

    /// <summary>For tests: writes a scene or a prefab into the project.</summary>
    /// <returns>The GUID.</returns>
    public static string AddFile(string path, string text)
    {
        string full = ToFile(path);
        Directory.CreateDirectory(Path.GetDirectoryName(full)!);
        File.WriteAllText(full, text);
        return Register(path, Guid.NewGuid().ToString("N"));
    }

    /// <summary>For tests: adds a script.</summary>
    public static void AddScript(string guid, Type type)
    {
        string path = $"Assets/Scripts/{type.Name}.cs";
        Register(path, guid);
        Add(path, new MonoScript(type) { name = type.Name });
    }

    /// <summary>For tests: forgets all assets.</summary>
    public static void Clear()
    {
        Files.Clear();
        PathsByGuid.Clear();
        FileIds.Clear();
    }

    public static string AssetPathToGUID(string path) => PathsByGuid.FirstOrDefault(file => file.Value == path).Key ?? "";

    public static string GUIDToAssetPath(string guid) => PathsByGuid.TryGetValue(guid, out string? path) ? path : "";

    public static string[] FindAssets(string filter) => FindAssets(filter, ["Assets"]);

    public static string[] FindAssets(string filter, string[] searchInFolders)
    {
        string[] words = filter.Split(' ');
        string[] extensions = words[^1] switch
        {
            "t:Scene" => [".unity"],
            // An imported model is a prefab, too.
            "t:Prefab" => [".prefab", ".fbx"],
            "t:MonoScript" => [".cs"],
            var other => throw new NotSupportedException(other),
        };
        return [.. PathsByGuid
            .Where(file => searchInFolders.Any(folder => file.Value.StartsWith(folder + "/", StringComparison.Ordinal)))
            .Where(file => extensions.Contains(Path.GetExtension(file.Value)))
            .Where(file => words[..^1].All(word => Path.GetFileName(file.Value).Contains(word, StringComparison.OrdinalIgnoreCase)))
            .Select(static file => file.Key)];
    }

    internal static string ToFile(string path) => Path.Combine(Path.GetDirectoryName(Application.dataPath)!, path);

    internal static Type? FindClass(string guid) => LoadAssetAtPath<MonoScript>(GUIDToAssetPath(guid))?.GetClass();

    /// <summary>The GUID of a script. One that no test has added gets one.</summary>
    internal static string GetScriptGuid(Type type)
    {
        string? path = Files.FirstOrDefault(file => file.Value.OfType<MonoScript>().Any(script => script.GetClass() == type)).Key;
        if (path is not null)
            return AssetPathToGUID(path);

        string guid = Guid.NewGuid().ToString("N");
        AddScript(guid, type);
        return guid;
    }

    private static string Register(string path, string guid)
    {
        PathsByGuid[guid] = path;
        return guid;
    }

    private static List<UnityEngine.Object>? Import(string path)
    {
        if (Path.GetExtension(path) != ".prefab" || AssetPathToGUID(path).Length == 0)
            return null;

        GameObject root = ObjectFile.Load(path, isAsset: true).Single();
        List<UnityEngine.Object> all = [root];
        foreach (Transform part in root.GetComponentsInChildren<Transform>(true))
            all.AddRange(part == root.transform ? part.gameObject.Components : [part.gameObject, .. part.gameObject.Components]);

        return Files[path] = all;
    }
}
