using System.Runtime.CompilerServices;

namespace NeuronMocap.Protocol;

/// <summary>Finds the boundaries of packets in a stream of bytes. It does not interpret their contents.</summary>
/// <remarks>
/// <para>
/// A packet has its second token 62 bytes after the first one; its header then gives the length. The stream has no checksum and no length prefix. After
/// unexpected bytes, the scanner can therefore only search for the next such place (protocol.md section 5). It checks limits in the header, before a
/// caller waits for the announced payload or stores it.
/// </para>
/// <para>
/// The scanner has no state. The caller keeps the bytes, and the length that <see cref="ScanStatus.NeedMoreData"/> asked for. Wait for that
/// length before the next call. A stream that arrives byte by byte then costs no more than one that arrives in large pieces.
/// </para>
/// <para>Any splitting of the same bytes gives the same packets and the same total of skipped bytes. Thread-safe.</para>
/// </remarks>
public sealed class PacketScanner
{
    private readonly int _maxValues;

    /// <summary>Creates a scanner.</summary>
    /// <param name="maxValues">Largest number of values that a packet may announce, 1 to 1,000,000; packets with more are skipped.</param>
    /// <exception cref="ArgumentOutOfRangeException">The limit is out of range.</exception>
    public PacketScanner(int maxValues = ProtocolConstants.DefaultMaxValues)
    {
        if (maxValues is < 1 or > ProtocolConstants.LargestMaxValues)
            throw new ArgumentOutOfRangeException(nameof(maxValues), maxValues, "The limit must be 1 to 1,000,000 values.");

        _maxValues = maxValues;
    }

    internal int MaxValues => _maxValues;

    /// <summary>Examines the start of a sequence of bytes.</summary>
    /// <param name="source">Bytes in the order of their arrival; they are only read.</param>
    /// <returns>A packet, a number of bytes to wait for, or a number of bytes to skip. The length is never zero.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public ScanResult Scan(ReadOnlySpan<byte> source)
    {
        if (source.Length < ProtocolConstants.HeaderSize)
            return ScanStart(source);

        // The compiler knows the length of a header, so reading a field checks no bound.
        ReadOnlySpan<byte> header = source[..ProtocolConstants.HeaderSize];
        PacketKind kind = PacketTokens.KindOf(header);
        if (kind == PacketKind.None)
            return Skip(source, SkipReason.NoTokens);
        if (kind == PacketKind.Motion && !DataVersion.IsKnown(header[2..]))
            return Skip(source, SkipReason.UnknownVersion);

        long payload = PayloadSize(header, kind);
        if (payload > PayloadLimit(kind))
            return Skip(source, SkipReason.TooLarge);

        int length = ProtocolConstants.HeaderSize + (int)payload;
        return source.Length < length ? NeedMoreData(length) : new ScanResult(ScanStatus.Packet, length, kind);
    }

    // Returns the length of the complete motion packet at the start, or 0. It is the usual packet, so it needs fewer steps than in Scan.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal int GetMotionLength(ReadOnlySpan<byte> source)
    {
        if (source.Length < ProtocolConstants.HeaderSize)
            return 0;

        ReadOnlySpan<byte> header = source[..ProtocolConstants.HeaderSize];
        if (!PacketTokens.IsMotion(header) || !DataVersion.IsKnown(header[2..]))
            return 0;

        uint values = MotionHeader.ReadValueCount(header);
        if (values > (uint)_maxValues)
            return 0;

        int length = ProtocolConstants.HeaderSize + (sizeof(float) * (int)values);
        return length <= source.Length ? length : 0;
    }

    // Whether the bytes begin with a complete header that this scanner accepts.
    internal bool StartsPacket(ReadOnlySpan<byte> source) =>
        source.Length >= ProtocolConstants.HeaderSize && Scan(source).Status != ScanStatus.Skipped;

    // Handles fewer bytes than a header.
    private static ScanResult ScanStart(ReadOnlySpan<byte> source)
    {
        if (source.Length == 0)
            return NeedMoreData(1);
        if (!MayStartPacket(source))
            return Skip(source, SkipReason.NoTokens);

        // After one byte, wait for the second byte, not for 64. The second byte of noise must be enough to skip it; otherwise the total would depend on
        // the splitting.
        return NeedMoreData(source.Length < 2 ? 2 : ProtocolConstants.HeaderSize);
    }

    private static ScanResult NeedMoreData(int length) => new(ScanStatus.NeedMoreData, length);

    // Skips to the next place that may start a packet; at least one byte.
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

    // Checks the second token only if the whole header is there. A shorter header must wait, whatever the splitting.
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
