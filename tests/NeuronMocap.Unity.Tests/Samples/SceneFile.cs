using System.Globalization;
using System.Reflection;

namespace NeuronMocap.Unity.Tests.Samples;

/// <summary>A scene in Unity's text format, as far as the samples use it: read, checked, and built in the engine.</summary>
internal sealed class SceneFile
{
    private const int GameObjectClass = 1;
    private const int TransformClass = 4;
    private const int ScriptClass = 114;

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
        string package = System.IO.Path.Combine(Repository.Root, "unity-package");
        string meta = Directory.EnumerateFiles(package, "*.cs.meta", SearchOption.AllDirectories)
            .Single(path => File.ReadLines(path).Contains($"guid: {guid}"));
        string name = System.IO.Path.GetFileName(meta)[..^".cs.meta".Length];
        return AppDomain.CurrentDomain.GetAssemblies()
            .Where(static assembly => assembly.GetName().Name is "NeuronMocap.Unity" or "NeuronMocap.Unity.Samples")
            .SelectMany(static assembly => assembly.GetTypes())
            .Single(type => type.Name == name && type.IsSubclassOf(typeof(MonoBehaviour)));
    }

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
            SetFields(script, (MonoBehaviour)objects[script.Id], objects);

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

    private static void SetFields(Document document, MonoBehaviour script, Dictionary<long, Object> objects)
    {
        foreach ((string name, string value) in document.Values.Where(static pair => pair.Key.StartsWith('_')))
        {
            FieldInfo field = FindField(script.GetType(), name) ?? throw new InvalidDataException($"{script.GetType().Name} has no field {name}.");
            field.SetValue(script, Convert(value, field.FieldType, objects));
        }
    }

    private static object Convert(string value, Type type, Dictionary<long, Object> objects)
    {
        if (typeof(Object).IsAssignableFrom(type))
            return objects[Reference(value)];
        if (type == typeof(bool))
            return value == "1";
        if (type.IsEnum)
            return Enum.ToObject(type, int.Parse(value, CultureInfo.InvariantCulture));

        return type == typeof(Vector3) ? Vector(value) : System.Convert.ChangeType(value, type, CultureInfo.InvariantCulture);
    }

    private static Vector3 Vector(string value)
    {
        float[] numbers = [.. value.Trim('{', '}').Split(", ").Select(static part => float.Parse(part[3..], CultureInfo.InvariantCulture))];
        return new Vector3(numbers[0], numbers[1], numbers[2]);
    }

    internal sealed class Document(int @class, long id)
    {
        private readonly Dictionary<string, string> _values = [];
        private readonly List<string> _items = [];

        public int Class => @class;

        public long Id => id;

        public IReadOnlyDictionary<string, string> Values => _values;

        /// <summary>The items of its lists.</summary>
        public IReadOnlyList<string> Items => _items;

        public string this[string name] => _values[name];

        public void Add(string name, string value) => _values.Add(name, value);

        public void Add(string item) => _items.Add(item);
    }
}
