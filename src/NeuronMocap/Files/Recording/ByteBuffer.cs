using System.Text;

namespace NeuronMocap.Recording;

// A buffer for building bytes. The memory grows and is reused.
internal sealed class ByteBuffer(int capacity)
{
    private byte[] _bytes = new byte[capacity];

    public byte[] Array => _bytes;

    public int Length { get; set; }

    public ReadOnlySpan<byte> Written => _bytes.AsSpan(0, Length);

    // Adds bytes for the caller to fill in.
    public Span<byte> Extend(int count)
    {
        Reserve(count);
        Length += count;
        return _bytes.AsSpan(Length - count, count);
    }

    public void Append(byte value) => Extend(1)[0] = value;

    public void Append(ReadOnlySpan<byte> bytes) => bytes.CopyTo(Extend(bytes.Length));

    // Seven bits in each byte, the lowest first. All bytes except the last have the highest bit set.
    public void AppendNumber(long value)
    {
        ulong rest = (ulong)value;
        for (; rest >= 0x80; rest >>= 7)
            Append((byte)(rest | 0x80));

        Append((byte)rest);
    }

    // Writes the length first, unless the text fills the rest of the entry anyway.
    public void AppendText(string text, bool withLength)
    {
        int count = Encoding.UTF8.GetByteCount(text);
        if (withLength)
            AppendNumber(count);

        _ = Encoding.UTF8.GetBytes(text, Extend(count));
    }

    private void Reserve(int count)
    {
        if (_bytes.Length - Length < count)
            System.Array.Resize(ref _bytes, Math.Max(Length + count, 2 * _bytes.Length));
    }
}
