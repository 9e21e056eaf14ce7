using System.Text;

namespace UnityEngine;

public class TextAsset : Object
{
    private readonly byte[] _bytes;

    public TextAsset()
        : this("")
    {
    }

    public TextAsset(string text)
        : this(Encoding.UTF8.GetBytes(text))
    {
    }

    internal TextAsset(byte[] bytes) => _bytes = bytes;

    public string text => Encoding.UTF8.GetString(_bytes);

    public byte[] bytes => [.. _bytes];
}
