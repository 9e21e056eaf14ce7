using System.Runtime.CompilerServices;

namespace NeuronMocap.Protocol;

/// <summary>
/// Finds where packets begin and end in a stream of bytes; it does not interpret what they carry.
/// <para>
/// A packet begins where its first token stands and its second one stands 62 bytes later; its header then gives the length. The stream has
/// no checksum and no length prefix, so after anything unexpected the only way back is the next such place (protocol.md section 5).
/// Limits are checked on the header, before anyone waits for or stores the announced payload.
/// </para>
/// <para>
/// All state between two calls is the bytes that the caller keeps and the length that <see cref="ScanStatus.NeedMoreData"/> asked for: waiting
/// for that length before the next call makes a stream that drips in byte by byte cost no more than one that arrives whole.
/// Any splitting of the same bytes gives the same packets and the same total of skipped bytes. Thread-safe.
/// </para>
/// </summary>
public sealed class PacketScanner
{
    private readonly int _maxValues;

    /// <summary>Makes a scanner.</summary>
    /// <param name="maxValues">Largest number of values that a packet may announce, 1 to 1,000,000; packets with more are skipped.</param>
    /// <exception cref="ArgumentOutOfRangeException">The limit is outside its range.</exception>
    public PacketScanner(int maxValues = ProtocolConstants.DefaultMaxValues)
    {
        if (maxValues is < 1 or > 1_000_000)
            throw new ArgumentOutOfRangeException(nameof(maxValues), maxValues, "The limit must be 1 to 1,000,000 values.");

        _maxValues = maxValues;
    }

    internal int MaxValues => _maxValues;

    /// <summary>Looks at the start of some bytes.</summary>
    /// <param name="source">Bytes in the order of their arrival; only read.</param>
    /// <returns>A packet, a number of bytes to wait for, or a number of bytes to skip; never a length of zero.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public ScanResult Scan(ReadOnlySpan<byte> source)
    {
        if (source.Length < ProtocolConstants.HeaderSize)
            return ScanStart(source);

        PacketKind kind = PacketTokens.KindOf(source);
        if (kind == PacketKind.None)
            return Skip(source, SkipReason.NoTokens);
        if (kind == PacketKind.Motion && !DataVersion.IsKnown(source[2..]))
            return Skip(source, SkipReason.UnknownVersion);

        long payload = PayloadSize(source, kind);
        if (payload > PayloadLimit(kind))
            return Skip(source, SkipReason.TooLarge);

        int length = ProtocolConstants.HeaderSize + (int)payload;
        return source.Length < length ? NeedMoreData(length) : new ScanResult(ScanStatus.Packet, length, kind);
    }

    // Whether the bytes begin with a whole header that this scanner accepts.
    internal bool StartsPacket(ReadOnlySpan<byte> source) =>
        source.Length >= ProtocolConstants.HeaderSize && Scan(source).Status != ScanStatus.Skipped;

    // Less than a header.
    private static ScanResult ScanStart(ReadOnlySpan<byte> source)
    {
        if (source.Length == 0)
            return NeedMoreData(1);
        if (!MayStartPacket(source))
            return Skip(source, SkipReason.NoTokens);

        // One byte asks for the second, not for 64: the second byte of noise has to be enough to skip it, or the total would depend on the
        // splitting.
        return NeedMoreData(source.Length < 2 ? 2 : ProtocolConstants.HeaderSize);
    }

    private static ScanResult NeedMoreData(int length) => new(ScanStatus.NeedMoreData, length);

    // Up to the next place that may start a packet; at least one byte.
    private static ScanResult Skip(ReadOnlySpan<byte> source, SkipReason reason)
    {
        int position = 1;
        while (position < source.Length)
        {
            int next = source[position..].IndexOfAny(ProtocolConstants.TokenStart, ProtocolConstants.StudioTokenStart);
            if (next < 0)
                return new ScanResult(ScanStatus.Skipped, source.Length, Reason: reason);

            position += next;
            if (MayStartPacket(source[position..]))
                break;

            position++;
        }

        return new ScanResult(ScanStatus.Skipped, position, Reason: reason);
    }

    // The second token is looked at only where the whole header is there: a shorter one has to wait whatever the splitting.
    private static bool MayStartPacket(ReadOnlySpan<byte> source)
    {
        if (source.Length >= ProtocolConstants.HeaderSize)
            return PacketTokens.KindOf(source) != PacketKind.None;

        return source.Length < 2 ? PacketTokens.IsStart(source[0]) : PacketTokens.KindOf(source[0], source[1]) != PacketKind.None;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static long PayloadSize(ReadOnlySpan<byte> header, PacketKind kind) => kind switch
    {
        PacketKind.Motion => sizeof(float) * (long)MotionHeader.ReadValueCount(header),
        PacketKind.Calculation => sizeof(float) * (long)CalculationHeader.ReadValueCount(header),
        PacketKind.StudioCalculation => StudioCalculationHeader.ReadByteCount(header),
        _ => DataCommandHeader.Read(header).PayloadSize,
    };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private long PayloadLimit(PacketKind kind) =>
        kind == PacketKind.Command ? ProtocolConstants.MaxCommandPayload : sizeof(float) * (long)_maxValues;
}
