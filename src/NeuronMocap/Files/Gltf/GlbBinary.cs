namespace NeuronMocap.Gltf;

// The binary part of a file: accessors, each in a view of its own, written one after the other.
internal sealed class GlbBinary
{
    // What a view holds for the graphics processor.
    public const int Vertices = 34962;
    public const int Triangles = 34963;

    private readonly List<(GlbAccessor Accessor, int? Target, long Offset, Action<Stream> Write)> _parts = [];

    public long Length { get; private set; }

    // Returns the number of the accessor.
    public int Add(GlbAccessor accessor, int? target, Action<Stream> write)
    {
        _parts.Add((accessor, target, Length, write));
        Length += Padded(accessor.ByteLength);
        return _parts.Count - 1;
    }

    public void Describe(GltfJson json)
    {
        if (_parts.Count == 0)
            return;

        json.Array("accessors");
        for (int i = 0; i < _parts.Count; i++)
            Describe(json, _parts[i].Accessor, i);

        json.EndArray().Array("bufferViews");
        foreach ((GlbAccessor accessor, int? target, long offset, _) in _parts)
        {
            json.Object().Number("buffer", 0).Number("byteOffset", offset).Number("byteLength", accessor.ByteLength);
            if (target is { } known)
                json.Number("target", known);

            json.EndObject();
        }

        json.EndArray().Array("buffers").Object().Number("byteLength", Length).EndObject().EndArray();
    }

    public void Write(Stream output)
    {
        byte[] padding = new byte[4];
        foreach ((GlbAccessor accessor, _, _, Action<Stream> write) in _parts)
        {
            write(output);
            output.Write(padding, 0, (int)(Padded(accessor.ByteLength) - accessor.ByteLength));
        }
    }

    public static long Padded(long length) => (length + 3) & ~3L;

    private static void Describe(GltfJson json, GlbAccessor accessor, int view)
    {
        json.Object().Number("bufferView", view).Number("componentType", accessor.ComponentType).Number("count", accessor.Count).Text("type", accessor.Type);
        if (accessor.IsNormalized)
            json.True("normalized");
        if (accessor.Min is { } min)
            json.Numbers("min", min);
        if (accessor.Max is { } max)
            json.Numbers("max", max);

        json.EndObject();
    }
}
