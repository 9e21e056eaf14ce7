namespace NeuronMocap.Gltf;

// Numbers in the binary part of a file, all of one kind. Limits are necessary for positions and for times.
internal sealed record GlbAccessor(int ComponentType, long Count, string Type)
{
    public const int UnsignedByte = 5121;
    public const int UnsignedShort = 5123;
    public const int Float = 5126;

    public bool IsNormalized { get; init; }

    public float[]? Min { get; init; }

    public float[]? Max { get; init; }

    public long ByteLength => Count * Components * ComponentSize;

    private int Components => Type switch
    {
        "SCALAR" => 1,
        "VEC3" => 3,
        "VEC4" => 4,
        _ => 16,
    };

    private int ComponentSize => ComponentType switch
    {
        UnsignedByte => 1,
        UnsignedShort => 2,
        _ => 4,
    };
}
