namespace NeuronMocap.Tests.Infrastructure;

/// <summary>Bytes assembled by hand, field by field, without code of the library.</summary>
internal sealed class WireBytes
{
    private readonly List<byte> _bytes = [];

    public WireBytes Hex(string hex)
    {
        _bytes.AddRange(Convert.FromHexString(hex.Replace(" ", "", StringComparison.Ordinal)));
        return this;
    }

    public WireBytes U8(int value)
    {
        _bytes.Add((byte)value);
        return this;
    }

    public WireBytes U16(int value) => U8(value & 0xFF).U8((value >> 8) & 0xFF);

    public WireBytes U32(uint value) => U16((int)(value & 0xFFFF)).U16((int)(value >> 16));

    public WireBytes Zeros(int count)
    {
        _bytes.AddRange(new byte[count]);
        return this;
    }

    public WireBytes Ascii(string text, int size)
    {
        foreach (char letter in text)
            U8(letter);

        return Zeros(size - text.Length);
    }

    public WireBytes Bytes(byte[] bytes, int size)
    {
        _bytes.AddRange(bytes);
        return Zeros(size - bytes.Length);
    }

    public WireBytes Floats(ReadOnlySpan<float> values)
    {
        foreach (float value in values)
            U32(BitConverter.SingleToUInt32Bits(value));

        return this;
    }

    public byte[] ToArray() => [.. _bytes];
}
