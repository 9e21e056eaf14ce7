using NeuronMocap.Protocol;

namespace NeuronMocap.Tests.Infrastructure;

/// <summary>What <see cref="ReferenceScanner"/> found.</summary>
/// <param name="Packets">The packets, in order.</param>
/// <param name="Trace">The same lines as those of a <see cref="StreamTrace"/>.</param>
/// <param name="Skipped">Bytes of no packet.</param>
/// <param name="Pending">Bytes at the end that may still become a packet.</param>
internal sealed record ReferenceReading(List<FoundPacket> Packets, List<string> Trace, long Skipped, int Pending);

/// <summary>
/// The rules of the stream, told slowly and over the whole of the bytes at once: what <see cref="PacketScanner"/> is compared with.
/// </summary>
internal static class ReferenceScanner
{
    public static ReferenceReading Read(byte[] bytes, int maxValues = 10_224)
    {
        List<FoundPacket> packets = [];
        List<string> trace = [];
        long skipped = 0;
        int at = 0;
        while (at < bytes.Length)
        {
            (long? size, SkipReason reason) = PacketSizeAt(bytes, at, maxValues);
            if (size is null)
            {
                if (reason != SkipReason.NoTokens)
                    trace.Add($"{reason} at {at}");

                at++;
                skipped++;
            }
            else if (at + size > bytes.Length)
            {
                break;
            }
            else
            {
                packets.Add(new FoundPacket(KindOf(bytes[at + 1]), bytes[at..(at + (int)size)]));
                trace.Add($"{KindOf(bytes[at + 1])} at {at}, {size} bytes");
                at += (int)size;
            }
        }

        trace.Add($"the rest at {at}");
        return new ReferenceReading(packets, trace, skipped, bytes.Length - at);
    }

    /// <summary>Whether the bytes begin with a whole header that is not refused.</summary>
    public static bool StartsWithHeader(byte[] bytes, int maxValues) =>
        bytes.Length >= 64 && PacketSizeAt(bytes, 0, maxValues).Size is not null;

    // The size of the packet that starts or may start here; null where none can, with the reason.
    private static (long? Size, SkipReason Reason) PacketSizeAt(byte[] bytes, int at, int maxValues)
    {
        int left = bytes.Length - at;
        if (bytes[at] != 0xFF)
            return (null, SkipReason.NoTokens);
        if (left >= 2 && KindOf(bytes[at + 1]) == PacketKind.None)
            return (null, SkipReason.NoTokens);
        if (left < 64)
            return (64, default);

        byte closing = bytes[at + 1] switch { 0xDD => 0xEE, 0x88 => 0x99, _ => 0xBB };
        if (bytes[at + 62] != 0xFF || bytes[at + 63] != closing)
            return (null, SkipReason.NoTokens);

        bool isMotion = bytes[at + 1] == 0xDD;
        if (isMotion && (bytes[at + 5] != 1 || bytes[at + 4] > 1))
            return (null, SkipReason.UnknownVersion);

        long count16 = bytes[at + 6] + (256L * bytes[at + 7]);
        long count32 = count16 + (65536L * bytes[at + 8]) + (16777216L * bytes[at + 9]);
        long? size = bytes[at + 1] == 0xAA ? CommandSize(bytes.AsSpan(at, 64))
            : isMotion && bytes[at + 4] == 1 ? Floats(count16, maxValues)
            : Floats(count32, maxValues);
        return (size, SkipReason.TooLarge);
    }

    private static long? Floats(long count, int maxValues) => count <= maxValues ? 64 + (4 * count) : null;

    private static long? CommandSize(ReadOnlySpan<byte> header)
    {
        long count = header[10] + (256L * header[11]) + (65536L * header[12]) + (16777216L * header[13]);
        long command = header[14] + (256L * header[15]) + (65536L * header[16]) + (16777216L * header[17]);
        long payload = command switch { 0 => 64 * count, 4 => count, _ => 0 };
        return payload <= 100_000 ? 64 + payload : null;
    }

    private static PacketKind KindOf(byte second) => second switch
    {
        0xDD => PacketKind.Motion,
        0x88 => PacketKind.Calculation,
        0xAA => PacketKind.Command,
        _ => PacketKind.None,
    };
}
