using System.Globalization;
using System.Reflection;
using UnityEngine.Playables;

namespace NeuronMocap.Unity.Tests.Samples;

/// <summary>A scene in Unity's text format, as far as the samples use it: read, checked, and built in the engine.</summary>
internal sealed class SceneFile
{
    // NeuronAnimatorInstance and NeuronTransformsInstance, whose scripts are missing on purpose.
    public static readonly string[] VendorScripts = ["41173daca41f9a64b8552925c6a3c363", "b9f969a3a049578478f71ba66294d9d5"];

    private const int GameObjectClass = 1;
    private const int TransformClass = 4;
    private const int ScriptClass = 114;
    private const int DirectorClass = 320;

    private readonly List<Document> _documents = [];

    private SceneFile(string path) => Path = path;

    public string Path { get; }

    public IReadOnlyList<Document> Documents => _documents;

    public IEnumerable<Document> Scripts => _documents.Where(static document => document.Class == ScriptClass);

    public static SceneFile Read(string path)
    {
        var scene = new SceneFile(path);
        foreach (string line in File.ReadLines(path))
        {
            if (line.StartsWith("--- !u!", StringComparison.Ordinal))
            {
                string[] words = line[7..].Split(" &");
                scene._documents.Add(new Document(int.Parse(words[0], CultureInfo.InvariantCulture), long.Parse(words[1], CultureInfo.InvariantCulture)));
            }
            else if (line.StartsWith("  - ", StringComparison.Ordinal))
            {
                scene._documents[^1].Add(line[4..]);
            }
            else if (line.StartsWith("    ", StringComparison.Ordinal))
            {
                scene._documents[^1].AddNested(line[4..]);
            }
            else if (line.StartsWith("  ", StringComparison.Ordinal))
            {
                int colon = line.IndexOf(':', StringComparison.Ordinal);
                scene._documents[^1].Add(line[2..colon], line[(colon + 1)..].Trim());
            }
        }

        return scene;
    }

    /// <summary>Finds the type of a script by the GUID in its meta file.</summary>
    public static Type FindScript(string guid)
    {
        string name = System.IO.Path.GetFileNameWithoutExtension(FindAsset(guid));
        return AppDomain.CurrentDomain.GetAssemblies()
            .Where(static assembly => assembly.GetName().Name is "NeuronMocap.Unity" or "NeuronMocap.Unity.Samples" or "NeuronMocap.Unity.Timeline")
            .SelectMany(static assembly => assembly.GetTypes())
            .Single(type => type.Name == name && (type.IsSubclassOf(typeof(MonoBehaviour)) || type.IsSubclassOf(typeof(ScriptableObject))));
    }

    /// <summary>Finds the file of an asset of the package by its GUID.</summary>
    public static string FindAsset(string guid) => Directory.EnumerateFiles(System.IO.Path.Combine(Repository.Root, "unity-package"), "*.meta", SearchOption.AllDirectories)
        .Single(path => File.ReadLines(path).Contains($"guid: {guid}"))[..^".meta".Length];

    /// <summary>Finds the serialised field for a name in a scene.</summary>
    public static FieldInfo? FindField(Type script, string name)
    {
        for (Type? type = script; type is not null; type = type.BaseType)
        {
            FieldInfo? field = type.GetField(name, BindingFlags.Instance | BindingFlags.NonPublic | BindingFlags.Public | BindingFlags.DeclaredOnly);
            if (field is not null && (field.IsPublic || field.IsDefined(typeof(SerializeField))))
                return field;
        }

        return null;
    }

    /// <summary>Creates the scene's objects. All are set before any of them wakes.</summary>
    public void Build()
    {
        var objects = new Dictionary<long, Object>();
        foreach (Document item in _documents.Where(static document => document.Class == GameObjectClass))
        {
            var created = new GameObject(item["m_Name"]) { tag = item["m_TagString"] };
            created.SetActive(false);
            objects[item.Id] = created;
        }

        foreach (Document part in _documents.Where(static document => document.Values.ContainsKey("m_GameObject")))
            objects[part.Id] = AddComponent(part, (GameObject)objects[Reference(part["m_GameObject"])]);

        foreach (Document part in _documents.Where(static document => document.Class == TransformClass && Reference(document["m_Father"]) != 0))
            ((Transform)objects[part.Id]).SetParent((Transform)objects[Reference(part["m_Father"])], false);

        foreach (Document script in Scripts)
            SetFields(script, objects[script.Id], objects);
        foreach (Document director in _documents.Where(static document => document.Class == DirectorClass))
            SetTimeline(director, (PlayableDirector)objects[director.Id], objects);

        foreach (GameObject item in objects.Values.OfType<GameObject>())
            item.SetActive(true);
    }

    public static long Reference(string value) => long.Parse(value["{fileID: ".Length..].TrimEnd('}').Split(',')[0], CultureInfo.InvariantCulture);

    public static string Guid(Document script) => script["m_Script"].Split("guid: ")[1].Split(',')[0];

    private static Component AddComponent(Document part, GameObject item)
    {
        switch (part.Class)
        {
            case TransformClass:
                item.transform.localPosition = Vector(part["m_LocalPosition"]);
                return item.transform;
            case DirectorClass:
                return item.AddComponent<PlayableDirector>();
            case 143:
                CharacterController controller = item.AddComponent<CharacterController>();
                (controller.height, controller.radius) = (Number(part["m_Height"]), Number(part["m_Radius"]));
                (controller.center, controller.minMoveDistance) = (Vector(part["m_Center"]), Number(part["m_MinMoveDistance"]));
                return controller;
            case 20:
                return item.AddComponent<Camera>();
            case 81:
                // The stand-in has no AudioListener.
                return item.transform;
            default:
                var script = (MonoBehaviour)(item.GetComponent(FindScript(Guid(part))) ?? item.AddComponent(FindScript(Guid(part))));
                script.enabled = part["m_Enabled"] == "1";
                return script;
        }
    }

    public static void SetFields(Document document, Object script, Dictionary<long, Object> objects)
    {
        foreach ((string name, string value) in document.Values.Where(static pair => pair.Key.StartsWith('_')))
        {
            FieldInfo field = FindField(script.GetType(), name) ?? throw new InvalidDataException($"{script.GetType().Name} has no field {name}.");
            if (document.Parts(name).SingleOrDefault() is { } nested)
                SetNested(field.GetValue(script)!, nested, objects);
            else
                field.SetValue(script, Convert(value, field.FieldType, objects));
        }
    }

    private static void SetNested(object settings, IReadOnlyDictionary<string, string> values, Dictionary<long, Object> objects)
    {
        foreach ((string name, string value) in values)
        {
            FieldInfo field = FindField(settings.GetType(), name) ?? throw new InvalidDataException($"{settings.GetType().Name} has no field {name}.");
            field.SetValue(settings, Convert(value, field.FieldType, objects));
        }
    }

    private static void SetTimeline(Document document, PlayableDirector director, Dictionary<long, Object> objects)
    {
        var timeline = TimelineFile.Load(FindAsset(document["m_PlayableAsset"].Split("guid: ")[1].Split(',')[0]));
        director.playableAsset = timeline.Asset;
        foreach (IReadOnlyDictionary<string, string> binding in document.Parts("m_SceneBindings"))
            director.SetGenericBinding(timeline.Tracks[Reference(binding["key"])], objects[Reference(binding["value"])]);
    }

    private static object? Convert(string value, Type type, Dictionary<long, Object> objects)
    {
        if (type == typeof(TextAsset))
            return new TextAsset(File.ReadAllBytes(FindAsset(value.Split("guid: ")[1].Split(',')[0])));
        if (typeof(Object).IsAssignableFrom(type))
            return Reference(value) == 0 ? null : objects[Reference(value)];
        if (type == typeof(bool))
            return value == "1";
        if (type.IsEnum)
            return Enum.ToObject(type, int.Parse(value, CultureInfo.InvariantCulture));

        return type == typeof(Vector3) ? Vector(value) : System.Convert.ChangeType(value, type, CultureInfo.InvariantCulture);
    }

    private static float Number(string value) => float.Parse(value, CultureInfo.InvariantCulture);

    private static Vector3 Vector(string value)
    {
        float[] numbers = [.. value.Trim('{', '}').Split(", ").Select(static part => Number(part[3..]))];
        return new Vector3(numbers[0], numbers[1], numbers[2]);
    }

    internal sealed class Document(int @class, long id)
    {
        private readonly Dictionary<string, string> _values = [];
        private readonly List<string> _items = [];
        private readonly List<(string Parent, Dictionary<string, string> Values)> _parts = [];
        private string _parent = "";

        public int Class => @class;

        public long Id => id;

        public IReadOnlyDictionary<string, string> Values => _values;

        /// <summary>The items of its lists.</summary>
        public IReadOnlyList<string> Items => _items;

        public string this[string name] => _values[name];

        /// <summary>Gets the nested values of a field: one set, or one for each item of a list. Deeper values are left out.</summary>
        public IEnumerable<IReadOnlyDictionary<string, string>> Parts(string parent) => _parts.Where(part => part.Parent == parent).Select(static part => part.Values);

        public void Add(string name, string value)
        {
            _values.Add(name, value);
            _parent = name;
        }

        public void Add(string item)
        {
            _items.Add(item);
            _parts.Add((_parent, []));
            AddNested(item);
        }

        public void AddNested(string line)
        {
            int colon = line.IndexOf(": ", StringComparison.Ordinal);
            if (line[0] is ' ' or '-' or '{' || colon < 0)
                return;

            if (_parts.Count == 0 || _parts[^1].Parent != _parent)
                _parts.Add((_parent, []));

            _parts[^1].Values.Add(line[..colon], line[(colon + 2)..]);
        }
    }
}
