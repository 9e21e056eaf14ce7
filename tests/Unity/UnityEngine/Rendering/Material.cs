namespace UnityEngine;

public class Material : Object
{
    private readonly Dictionary<int, object> _values = [];

    public Material(Shader shader)
    {
        if (shader is null)
            throw new ArgumentNullException(nameof(shader));

        this.shader = shader;
    }

    public Material(Material source)
    {
        shader = source.shader;
        name = source.name;
        foreach ((int key, object value) in source._values)
            _values[key] = value;
    }

    public Shader shader { get; set; }

    public int renderQueue { get; set; } = -1;

    public Color color
    {
        get => GetColor(shader.MainColor);
        set => SetColor(shader.MainColor, value);
    }

    public Texture? mainTexture
    {
        get => _values.TryGetValue(Shader.PropertyToID(shader.MainTexture), out object? value) ? (Texture?)value : null;
        set => _values[Shader.PropertyToID(shader.MainTexture)] = value!;
    }

    public Vector2 mainTextureScale { get; set; } = Vector2.one;

    public bool HasProperty(string name) => shader.Has(Shader.PropertyToID(name));

    public bool HasProperty(int nameID) => shader.Has(nameID);

    public Color GetColor(string name) => GetColor(Shader.PropertyToID(name));

    public Color GetColor(int nameID) => _values.TryGetValue(nameID, out object? value) ? (Color)value : Color.white;

    public void SetColor(string name, Color value) => SetColor(Shader.PropertyToID(name), value);

    public void SetColor(int nameID, Color value) => _values[nameID] = value;

    public float GetFloat(string name) => _values.TryGetValue(Shader.PropertyToID(name), out object? value) ? (float)value : 0;

    public void SetFloat(string name, float value) => SetFloat(Shader.PropertyToID(name), value);

    public void SetFloat(int nameID, float value) => _values[nameID] = value;

    public bool SetPass(int pass) => true;
}
