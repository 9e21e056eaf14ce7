namespace NeuronMocap.Fuzz.Inputs;

/// <summary>The input being created, at most <see cref="FuzzInput.MaxLength"/> bytes. Bytes that do not fit are omitted.</summary>
internal sealed class InputBuffer
{
    private readonly byte[] _bytes = new byte[FuzzInput.MaxLength];
    private readonly byte[] _other = new byte[FuzzInput.MaxLength];

    public int Length { get; private set; }

    public Span<byte> Bytes => _bytes.AsSpan(0, Length);

    public void Clear() => Length = 0;

    public void Append(ReadOnlySpan<byte> bytes) => Insert(Length, bytes);

    public void CutAt(int length) => Length = length;

    public void Keep(int start, int count)
    {
        count = Math.Min(count, Length - start);
        _bytes.AsSpan(start, count).CopyTo(_bytes);
        Length = count;
    }

    public void Overwrite(int at, ReadOnlySpan<byte> bytes)
    {
        if (at < Length)
            bytes[..Math.Min(bytes.Length, Length - at)].CopyTo(_bytes.AsSpan(at));
    }

    public void Remove(int at, int count)
    {
        count = Math.Min(count, Length - at);
        _bytes.AsSpan(at + count, Length - at - count).CopyTo(_bytes.AsSpan(at));
        Length -= count;
    }

    /// <summary>Inserts bytes, which must not be from this buffer; see <see cref="Copy"/>.</summary>
    public void Insert(int at, ReadOnlySpan<byte> bytes)
    {
        bytes = bytes[..Math.Min(bytes.Length, FuzzInput.MaxLength - Length)];
        _bytes.AsSpan(at, Length - at).CopyTo(_bytes.AsSpan(at + bytes.Length));
        bytes.CopyTo(_bytes.AsSpan(at));
        Length += bytes.Length;
    }

    public void Replace(int at, int count, ReadOnlySpan<byte> bytes)
    {
        Remove(at, count);
        Insert(at, bytes);
    }

    /// <summary>Returns a section of some bytes, for insertion into this buffer. Valid until the next call.</summary>
    public ReadOnlySpan<byte> Copy(ReadOnlySpan<byte> bytes, int at, int count)
    {
        ReadOnlySpan<byte> stretch = bytes[at..Math.Min(at + count, bytes.Length)];
        stretch.CopyTo(_other);
        return _other.AsSpan(0, stretch.Length);
    }
}
