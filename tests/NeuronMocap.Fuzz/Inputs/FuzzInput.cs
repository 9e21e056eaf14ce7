namespace NeuronMocap.Fuzz.Inputs;

/// <summary>
/// The bytes that a target reads, surrounded by bytes that it must not touch, and the results of the target. A target derives random choices, such as
/// where to cut, from the bytes too. The bytes alone thus reproduce a failure.
/// </summary>
internal sealed class FuzzInput
{
    /// <summary>The longest input.</summary>
    public const int MaxLength = 1 << 16;

    private const int Margin = 64;

    private readonly byte[] _memory = new byte[MaxLength + (2 * Margin) + sizeof(ulong)];
    private Digest _digest;
    private FuzzRandom _random;

    /// <summary>The input, for code that takes arrays.</summary>
    public ArraySegment<byte> Segment { get; private set; }

    public ReadOnlySpan<byte> Bytes => Segment;

    /// <summary>A digest of everything that was read, to compare two readings.</summary>
    public ref Digest Digest => ref _digest;

    public ref FuzzRandom Random => ref _random;

    /// <summary>The number of recognised items. It shows whether inputs get past the first check.</summary>
    public long Found { get; set; }

    /// <summary>Returns whether the input or its surroundings changed.</summary>
    public bool IsTouched(ReadOnlySpan<byte> original, Surroundings surroundings) =>
        !Bytes.SequenceEqual(original)
        || !Before.SequenceEqual(Repeat(surroundings)[..Before.Length])
        || !Behind.SequenceEqual(Repeat(surroundings)[..Behind.Length]);

    /// <summary>Stores the bytes, at any alignment.</summary>
    public void Set(ReadOnlySpan<byte> bytes, Surroundings surroundings)
    {
        ulong hash = Inputs.Digest.Of(bytes);
        Segment = new ArraySegment<byte>(_memory, Margin + (int)(hash % sizeof(ulong)), bytes.Length);
        bytes.CopyTo(Segment);
        Repeat(surroundings)[..Before.Length].CopyTo(Before);
        Repeat(surroundings)[..Behind.Length].CopyTo(Behind);
        _digest = default;
        _random = new FuzzRandom(hash);
        Found = 0;
    }

    private Span<byte> Before => _memory.AsSpan(Segment.Offset - Margin, Margin);

    private Span<byte> Behind => _memory.AsSpan(Segment.Offset + Segment.Count, Margin);

    // Bytes that a reader out of bounds would take for the rest of a packet, or bytes without meaning.
    private static ReadOnlySpan<byte> Repeat(Surroundings surroundings) => surroundings == Surroundings.Tokens
        ? [
            0xFF, 0xDD, 0, 0, 1, 1, 1, 0, 0xFF, 0xEE, 0xFF, 0x88, 0xFF, 0x99, 0xFF, 0xAA,
            0xFF, 0xDD, 0, 0, 1, 1, 1, 0, 0xFF, 0xEE, 0xFF, 0x88, 0xFF, 0x99, 0xFF, 0xAA,
            0xFF, 0xDD, 0, 0, 1, 1, 1, 0, 0xFF, 0xEE, 0xFF, 0x88, 0xFF, 0x99, 0xFF, 0xAA,
            0xFF, 0xDD, 0, 0, 1, 1, 1, 0, 0xFF, 0xEE, 0xFF, 0x88, 0xFF, 0x99, 0xFF, 0xAA,
        ]
        : "9 9 9 9 9 9 9 9 9 9 9 9 9 9 9 9 9 9 9 9 9 9 9 9 9 9 9 9 9 9 9 9 "u8;
}

/// <summary>Specifies the bytes before and after an input.</summary>
internal enum Surroundings
{
    Tokens,
    Digits,
}
