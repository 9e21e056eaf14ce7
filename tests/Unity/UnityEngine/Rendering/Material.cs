namespace UnityEngine;

public class Material : Object
{
    private readonly Dictionary<string, object> _values = [];

    public Material(Shader shader) => this.shader = shader;

    public Material(Material source)
    {
        shader = source.shader;
        foreach ((string key, object value) in source._values)
            _values[key] = value;
    }

    public Shader shader { get; set; }

    public int renderQueue { get; set; } = -1;

    public Color color
    {
        get => GetColor("_Color");
        set => SetColor("_Color", value);
    }

    public bool HasProperty(string name) => true;

    public Color GetColor(string name) => _values.TryGetValue(name, out object? value) ? (Color)value : Color.white;

    public void SetColor(string name, Color value) => _values[name] = value;

    public float GetFloat(string name) => _values.TryGetValue(name, out object? value) ? (float)value : 0;

    public void SetFloat(string name, float value) => _values[name] = value;

    public bool SetPass(int pass) => true;
}

public sealed class Shader : Object
{
    private Shader()
    {
    }

    public bool isSupported => true;

    public static Shader? Find(string name) => new() { name = name };

    public static int PropertyToID(string name) => name.GetHashCode(StringComparison.Ordinal);
}
