using System.Globalization;
using System.Text;

namespace NeuronMocap.Gltf;

// Writes JSON text. .NET Standard has no JSON writer, and glTF needs little. Values are finite numbers, texts, arrays and objects.
internal sealed class GltfJson
{
    private readonly StringBuilder _text = new();
    private bool _isFollowing;

    public GltfJson Object(string? name = null) => Open(name, '{');

    public GltfJson EndObject() => Close('}');

    public GltfJson Array(string? name = null) => Open(name, '[');

    public GltfJson EndArray() => Close(']');

    public GltfJson Text(string name, string value)
    {
        Begin(name);
        AddText(value);
        return this;
    }

    public GltfJson Number(string? name, long value)
    {
        Begin(name);
        _text.Append(value.ToString(CultureInfo.InvariantCulture));
        return this;
    }

    public GltfJson True(string name)
    {
        Begin(name);
        _text.Append("true");
        return this;
    }

    // All digits of the binary32 value: readers compare the limits of an accessor with its values.
    public GltfJson Number(string? name, float value)
    {
        Begin(name);
        _text.Append(((double)value).ToString("R", CultureInfo.InvariantCulture));
        return this;
    }

    public GltfJson Numbers(string name, params float[] values)
    {
        Array(name);
        foreach (float value in values)
            Number(null, value);

        return EndArray();
    }

    public GltfJson Numbers(string name, IEnumerable<int> values)
    {
        Array(name);
        foreach (int value in values)
            Number(null, value);

        return EndArray();
    }

    // A surrogate without its other half becomes the replacement character.
    public byte[] ToUtf8() => Encoding.UTF8.GetBytes(_text.ToString());

    private GltfJson Open(string? name, char bracket)
    {
        Begin(name);
        _text.Append(bracket);
        _isFollowing = false;
        return this;
    }

    private GltfJson Close(char bracket)
    {
        _text.Append(bracket);
        _isFollowing = true;
        return this;
    }

    private void Begin(string? name)
    {
        if (_isFollowing)
            _text.Append(',');

        _isFollowing = true;
        if (name is null)
            return;

        AddText(name);
        _text.Append(':');
    }

    private void AddText(string value)
    {
        _text.Append('"');
        foreach (char character in value)
        {
            if (character is '"' or '\\')
                _text.Append('\\').Append(character);
            else if (character < ' ')
                _text.Append("\\u").Append(((int)character).ToString("x4", CultureInfo.InvariantCulture));
            else
                _text.Append(character);
        }

        _text.Append('"');
    }
}
