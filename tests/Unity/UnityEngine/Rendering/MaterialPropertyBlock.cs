namespace UnityEngine;

public sealed class MaterialPropertyBlock
{
    private readonly Dictionary<int, object> _values = [];

    public bool isEmpty => _values.Count == 0;

    public void SetColor(string name, Color value) => SetColor(Shader.PropertyToID(name), value);

    public void SetColor(int nameID, Color value) => _values[nameID] = value;

    public Color GetColor(string name) => GetColor(Shader.PropertyToID(name));

    public Color GetColor(int nameID) => _values.TryGetValue(nameID, out object? value) ? (Color)value : default;

    public void SetFloat(string name, float value) => SetFloat(Shader.PropertyToID(name), value);

    public void SetFloat(int nameID, float value) => _values[nameID] = value;

    public void Clear() => _values.Clear();

    internal MaterialPropertyBlock Copy()
    {
        var copy = new MaterialPropertyBlock();
        copy.CopyFrom(this);
        return copy;
    }

    internal void CopyFrom(MaterialPropertyBlock? other)
    {
        _values.Clear();
        foreach ((int key, object value) in other?._values ?? [])
            _values[key] = value;
    }
}
