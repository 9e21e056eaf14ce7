namespace UnityEditor;

public class AssetImporter : UnityEngine.Object
{
    private static readonly Dictionary<string, AssetImporter> Importers = [];

    public string assetPath { get; private set; } = "";

    /// <summary>For tests: the number of calls to SaveAndReimport, and its effect.</summary>
    public int Imports { get; private set; }

    public Action? Imported { get; set; }

    public static AssetImporter? GetAtPath(string path) => Importers.TryGetValue(path, out AssetImporter? found) ? found : null;

    /// <summary>For tests: adds an importer for a file of the project.</summary>
    public static T Add<T>(string path, T importer)
        where T : AssetImporter
    {
        importer.assetPath = path;
        Importers[path] = importer;
        return importer;
    }

    public void SaveAndReimport()
    {
        Imports++;
        Imported?.Invoke();
    }
}
