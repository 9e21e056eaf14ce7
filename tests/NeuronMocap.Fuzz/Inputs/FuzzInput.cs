namespace NeuronMocap.Fuzz.Inputs;

/// <summary>
/// The bytes that a target reads, amid other bytes that it has to leave alone, and what it says about them. Chances that a target takes,
/// such as where to cut, come from the bytes too, so that they alone repeat a failure.
/// </summary>
internal sealed class FuzzInput
{
    /// <summary>Longest input.</summary>
    public const int MaxLength = 1 << 16;

    private const int Margin = 64;

    private readonly byte[] _memory = new byte[MaxLength + (2 * Margin) + sizeof(ulong)];
    private Digest _digest;
    private FuzzRandom _random;

    /// <summary>The input, for code that takes arrays.</summary>
    public ArraySegment<byte> Segment { get; private set; }

    public ReadOnlySpan<byte> Bytes => Segment;

    /// <summary>Takes in everything that was read, so that two readings can be compared.</summary>
    public ref Digest Digest => ref _digest;

    public ref FuzzRandom Random => ref _random;

    /// <summary>How many things were recognised: shows whether the inputs reach behind the first check.</summary>
    public long Found { get; set; }

    /// <summary>Whether the input or its surroundings are no longer what they were.</summary>
    public bool IsTouched(ReadOnlySpan<byte> original, Surroundings surroundings) =>
        !Bytes.SequenceEqual(original)
        || !Before.SequenceEqual(Repeat(surroundings)[..Before.Length])
        || !Behind.SequenceEqual(Repeat(surroundings)[..Behind.Length]);

    /// <summary>Puts bytes into place, at any alignment.</summary>
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

    // Bytes that a reader out of bounds would take for the rest of a packet, and bytes that stand for nothing.
    private static ReadOnlySpan<byte> Repeat(Surroundings surroundings) => surroundings == Surroundings.Tokens
        ? [
            0xFF, 0xDD, 0, 0, 1, 1, 1, 0, 0xFF, 0xEE, 0xFF, 0x88, 0xFF, 0x99, 0xFF, 0xAA,
            0xFF, 0xDD, 0, 0, 1, 1, 1, 0, 0xFF, 0xEE, 0xFF, 0x88, 0xFF, 0x99, 0xFF, 0xAA,
            0xFF, 0xDD, 0, 0, 1, 1, 1, 0, 0xFF, 0xEE, 0xFF, 0x88, 0xFF, 0x99, 0xFF, 0xAA,
            0xFF, 0xDD, 0, 0, 1, 1, 1, 0, 0xFF, 0xEE, 0xFF, 0x88, 0xFF, 0x99, 0xFF, 0xAA,
        ]
        : "9 9 9 9 9 9 9 9 9 9 9 9 9 9 9 9 9 9 9 9 9 9 9 9 9 9 9 9 9 9 9 9 "u8;
}

/// <summary>What lies before and behind an input.</summary>
internal enum Surroundings
{
    Tokens,
    Digits,
}
