using System.Globalization;
using System.Reflection;
using UnityEngine;
using UnityEngine.StandIn;

namespace UnityEditor;

/// <summary>
/// One object for the project, read from its file on first use. Here, the file has a line for each field and is not Unity's YAML.
/// </summary>
public class ScriptableSingleton<T> : ScriptableObject
    where T : ScriptableObject
{
    private static T? _instance;

    public static T instance => _instance != null ? _instance : _instance = Load();

    /// <summary>For tests: the next object is read from the file, as after a restart.</summary>
    public static void Forget() => _instance = null;

    protected static string GetFilePath() =>
        typeof(T).GetCustomAttribute<FilePathAttribute>()?.RelativePath ?? throw new InvalidOperationException($"{typeof(T).Name} has no [FilePath].");

    protected virtual void Save(bool saveAsText)
    {
        string path = GetFilePath();
        Directory.CreateDirectory(Path.GetDirectoryName(path)!);
        File.WriteAllText(path, string.Concat(
            Serialization.GetFields(typeof(T)).Select(field => $"{field.Name}: {Convert.ToString(field.GetValue(this), CultureInfo.InvariantCulture)}\n")));
    }

    private static T Load()
    {
        T loaded = CreateInstance<T>();
        loaded.hideFlags = HideFlags.HideAndDontSave;
        if (!File.Exists(GetFilePath()))
            return loaded;

        foreach (string line in File.ReadAllLines(GetFilePath()))
        {
            string[] parts = line.Split(": ", 2);
            FieldInfo field = Serialization.GetFields(typeof(T)).Single(field => field.Name == parts[0]);
            field.SetValue(loaded, field.FieldType.IsEnum
                ? Enum.Parse(field.FieldType, parts[1])
                : Convert.ChangeType(parts[1], field.FieldType, CultureInfo.InvariantCulture));
        }

        return loaded;
    }
}
