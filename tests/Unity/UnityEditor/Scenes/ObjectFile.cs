using System.Globalization;
using System.Reflection;
using UnityEngine;
using UnityEngine.StandIn;
using Object = UnityEngine.Object;

namespace UnityEditor;

/// <summary>
/// Reads scenes and prefabs in Unity's text format: objects, transforms, Animators, scripts with plain fields and references, missing scripts, and
/// instances of prefabs. Lists and nested fields keep their defaults.
/// </summary>
internal sealed partial class ObjectFile
{
    private readonly string _guid;
    private readonly List<Entry> _entries = [];
    private readonly Dictionary<long, Object> _objects = [];
    private readonly List<(MonoBehaviour Script, Entry Entry)> _scripts = [];
    private readonly List<GameObject> _roots = [];

    private ObjectFile(string path)
    {
        _guid = AssetDatabase.AssetPathToGUID(path);
        foreach (string line in File.ReadLines(AssetDatabase.ToFile(path)))
        {
            if (line.StartsWith("--- !u!", StringComparison.Ordinal))
                _entries.Add(new Entry(line));
            else if (_entries.Count > 0)
                _entries[^1].Lines.Add(line);
        }
    }

    public static IReadOnlyList<GameObject> Load(string path, bool isAsset)
    {
        var file = new ObjectFile(path);
        bool outside = World.IsMakingAsset;
        World.IsMakingAsset = isAsset;
        try
        {
            file.Build();
        }
        finally
        {
            World.IsMakingAsset = outside;
        }

        return file._roots;
    }

    private void Build()
    {
        foreach (Entry entry in _entries.Where(static entry => entry.Class == 1001))
            Instantiate(entry);
        foreach (Entry entry in _entries.Where(static entry => entry is { Class: 1, IsStripped: false }))
        {
            var made = new GameObject(entry["m_Name"]);
            made.SetActive(entry["m_IsActive"] != "0");
            Register(entry, made);
            _roots.Add(made);
        }

        foreach (Entry entry in _entries.Where(static entry => entry is { Class: not 1, IsStripped: false } && entry["m_GameObject"].Length > 0))
            AddComponent(entry, (GameObject)_objects[entry.Reference("m_GameObject")]);
        foreach (Entry entry in _entries.Where(static entry => entry is { Class: 4, IsStripped: false }))
        {
            if (Find(entry, "m_Father") is not Transform father)
                continue;

            ((Transform)_objects[entry.Id]).SetParent(father, false);
            _roots.Remove(((Transform)_objects[entry.Id]).gameObject);
        }

        foreach ((MonoBehaviour script, Entry entry) in _scripts)
            SetFields(script, entry);
    }

    private void Instantiate(Entry entry)
    {
        string path = AssetDatabase.GUIDToAssetPath(entry.Guid("m_SourcePrefab"));
        GameObject prefab = AssetDatabase.LoadAssetAtPath<GameObject>(path) ?? throw new InvalidDataException($"There is no prefab {path}.");
        GameObject copy = Object.Instantiate(prefab);
        copy.name = prefab.name;
        _roots.Add(copy);
        Entry[] stubs = [.. _entries.Where(other => other.IsStripped && other.Reference("m_PrefabInstance") == entry.Id)];
        foreach ((Object source, Object made) in Pair(prefab, copy))
        {
            long local = FileIds.Of(source)!.Local;
            Entry? stub = stubs.FirstOrDefault(other => other.Reference("m_CorrespondingSourceObject") == local);
            FileIds.Set(made, new FileId(_guid, local, entry.Id, stub?.Id ?? 0, source));
            if (stub is not null)
                _objects[stub.Id] = made;
        }

        InstanceTexts.AddOrUpdate(copy, entry.ToString());
    }

    private static IEnumerable<(Object Source, Object Made)> Pair(GameObject source, GameObject made)
    {
        yield return (source, made);
        for (int i = 0; i < source.Components.Count; i++)
            yield return (source.Components[i], made.Components[i]);

        for (int i = 0; i < source.transform.childCount; i++)
        {
            foreach ((Object, Object) below in Pair(source.transform.GetChild(i).gameObject, made.transform.GetChild(i).gameObject))
                yield return below;
        }
    }

    private void AddComponent(Entry entry, GameObject owner)
    {
        switch (entry.Class)
        {
            case 4:
                Register(entry, owner.transform);
                break;
            case 95:
                Register(entry, owner.AddComponent<Animator>());
                break;
            case 114 when AssetDatabase.FindClass(entry.Guid("m_Script")) is { } type:
                var script = (MonoBehaviour)owner.Create(type);
                script.enabled = entry["m_Enabled"] != "0";
                Register(entry, script);
                _scripts.Add((script, entry));
                break;
            case 114:
                owner.MissingScripts = [.. owner.MissingScripts, entry.ToString()];
                break;
            default:
                throw new NotSupportedException($"A component of class {entry.Class}.");
        }
    }

    private void SetFields(MonoBehaviour script, Entry entry)
    {
        foreach (FieldInfo field in Serialization.GetFields(script.GetType()))
        {
            string value = entry[field.Name];
            if (value.Length == 0)
                continue;

            if (typeof(Object).IsAssignableFrom(field.FieldType))
                field.SetValue(script, Find(entry, field.Name));
            else if (field.FieldType == typeof(bool))
                field.SetValue(script, value == "1");
            else if (field.FieldType.IsEnum)
                field.SetValue(script, Enum.ToObject(field.FieldType, int.Parse(value, CultureInfo.InvariantCulture)));
            else if (field.FieldType.IsPrimitive || field.FieldType == typeof(string))
                field.SetValue(script, Convert.ChangeType(value.Trim('\''), field.FieldType, CultureInfo.InvariantCulture));
        }
    }

    private Object? Find(Entry entry, string name) => _objects.TryGetValue(entry.Reference(name), out Object? found) ? found : null;

    private void Register(Entry entry, Object item)
    {
        _objects.Add(entry.Id, item);
        FileIds.Set(item, new FileId(_guid, entry.Id));
    }

    private sealed class Entry
    {
        public Entry(string header)
        {
            Header = header;
            string[] words = header["--- !u!".Length..].Split(' ');
            Class = int.Parse(words[0], CultureInfo.InvariantCulture);
            Id = long.Parse(words[1].TrimStart('&'), CultureInfo.InvariantCulture);
            IsStripped = words.Length > 2;
        }

        public string Header { get; }

        public int Class { get; }

        public long Id { get; }

        public bool IsStripped { get; }

        public List<string> Lines { get; } = [];

        /// <summary>A value of the first level, or an empty string.</summary>
        public string this[string name] => Lines.Find(line => line.StartsWith($"  {name}:", StringComparison.Ordinal))?[(name.Length + 3)..].Trim() ?? "";

        public long Reference(string name) => Part(this[name], "fileID: ") is { Length: > 0 } id ? long.Parse(id, CultureInfo.InvariantCulture) : 0;

        public string Guid(string name) => Part(this[name], "guid: ");

        public override string ToString() => string.Join("\n", [Header, .. Lines]);

        private static string Part(string value, string label) =>
            value.Contains(label, StringComparison.Ordinal) ? value.Split(label)[1].Split(',', '}')[0] : "";
    }
}
