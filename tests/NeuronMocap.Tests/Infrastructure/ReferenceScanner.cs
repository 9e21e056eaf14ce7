using NeuronMocap.Protocol;

namespace NeuronMocap.Tests.Infrastructure;

/// <summary>The result of <see cref="ReferenceScanner"/>.</summary>
/// <param name="packets">The packets, in order. Lines of text are represented by their images.</param>
/// <param name="trace">The same lines as those of a <see cref="StreamTrace"/>.</param>
/// <param name="place">The meaning of the position to the text format.</param>
internal sealed class ReferenceReading(List<FoundPacket> packets, List<string> trace, ReferencePlace place)
{
    public List<FoundPacket> Packets => packets;

    public List<string> Trace => trace;

    public ReferencePlace Place { get; set; } = place;

    public int At { get; set; }

    /// <summary>The number of bytes outside packets and lines.</summary>
    public long Skipped { get; set; }

    /// <summary>The number of bytes in lines and between them.</summary>
    public long Text { get; set; }

    /// <summary>The number of bytes at the end that may still become a packet or a line.</summary>
    public int Pending { get; set; }
}

/// <summary>
/// The rules of the stream, implemented slowly and on all bytes at once, for comparison with <see cref="PacketScanner"/>.
/// </summary>
internal static class ReferenceScanner
{
    public static ReferenceReading Read(byte[] bytes, int maxValues = 10_224, ReferencePlace place = ReferencePlace.Start)
    {
        var reading = new ReferenceReading([], [], place);
        while (reading.At < bytes.Length && Take(reading, bytes, maxValues))
        {
        }

        reading.Trace.Add($"the rest at {reading.At}");
        reading.Pending = bytes.Length - reading.At;
        return reading;
    }

    // Returns false if the packet or line at the position is incomplete.
    private static bool Take(ReferenceReading reading, byte[] bytes, int maxValues)
    {
        byte first = bytes[reading.At];
        if (reading.Place == ReferencePlace.Noise || first is 0xFF or 0xCF)
            return TakePacketOrByte(reading, bytes, maxValues);
        if (!ReferenceText.IsBlank(first))
            return TakeLineOrByte(reading, bytes, maxValues);

        reading.At++;
        if (reading.Place == ReferencePlace.BehindLine)
        {
            reading.Text++;
            return true;
        }

        reading.Skipped++;
        if (first == '\n')
            reading.Place = ReferencePlace.Start;

        return true;
    }

    private static bool TakeLineOrByte(ReferenceReading reading, byte[] bytes, int maxValues)
    {
        ReferenceLine line = ReferenceText.ReadAt(bytes.AsSpan(reading.At), maxValues, reading.Place == ReferencePlace.Unsure);
        switch (line.Kind)
        {
            case ReferenceLineKind.Unfinished:
                return false;
            case ReferenceLineKind.NoLine:
                return TakePacketOrByte(reading, bytes, maxValues);
            case ReferenceLineKind.Frame:
                reading.Packets.Add(line.Packet!);
                reading.Trace.Add(StreamTrace.Line(line.Packet!.Kind, reading.At, line.Packet.Bytes));
                reading.Text += line.Length;
                break;
            default:
                if (line.Reason != SkipReason.NoTokens)
                    reading.Trace.Add($"{line.Reason} at {reading.At}");

                reading.Skipped += line.Length;
                break;
        }

        reading.At += line.Length;
        reading.Place = line.Place;
        return true;
    }

    private static bool TakePacketOrByte(ReferenceReading reading, byte[] bytes, int maxValues)
    {
        int at = reading.At;
        (long? size, SkipReason reason) = PacketSizeAt(bytes, at, maxValues);
        if (size is null)
        {
            if (reason != SkipReason.NoTokens)
                reading.Trace.Add($"{reason} at {at}");

            reading.Place = bytes[at] == '\n' ? ReferencePlace.Start : ReferencePlace.Noise;
            reading.At++;
            reading.Skipped++;
            return true;
        }

        if (at + size > bytes.Length)
            return false;

        PacketKind kind = KindOf(bytes[at], bytes[at + 1]);
        reading.Packets.Add(new FoundPacket(kind, bytes[at..(at + (int)size)]));
        reading.Trace.Add($"{kind} at {at}, {size} bytes");
        reading.At += (int)size;
        reading.Place = ReferencePlace.Start;
        return true;
    }

    /// <summary>Returns whether the bytes start with a whole header that is not rejected.</summary>
    public static bool StartsWithHeader(byte[] bytes, int maxValues) =>
        bytes.Length >= 64 && PacketSizeAt(bytes, 0, maxValues).Size is not null;

    // Returns the size of the packet that starts or may start here. If none can, returns null and the reason.
    private static (long? Size, SkipReason Reason) PacketSizeAt(byte[] bytes, int at, int maxValues)
    {
        int left = bytes.Length - at;
        if (bytes[at] is not (0xFF or 0xCF))
            return (null, SkipReason.NoTokens);
        if (left >= 2 && KindOf(bytes[at], bytes[at + 1]) == PacketKind.None)
            return (null, SkipReason.NoTokens);
        if (left < 64)
            return (64, default);

        byte closing = bytes[at + 1] switch { 0xDD => 0xEE, 0x88 => 0x99, 0xDC => 0xEC, _ => 0xBB };
        if (bytes[at + 62] != bytes[at] || bytes[at + 63] != closing)
            return (null, SkipReason.NoTokens);

        bool isMotion = bytes[at + 1] == 0xDD;
        if (isMotion && (bytes[at + 5] != 1 || bytes[at + 4] > 1))
            return (null, SkipReason.UnknownVersion);

        long count16 = bytes[at + 6] + (256L * bytes[at + 7]);
        long count32 = count16 + (65536L * bytes[at + 8]) + (16777216L * bytes[at + 9]);
        long? size = bytes[at + 1] switch
        {
            0xAA => CommandSize(bytes.AsSpan(at, 64)),
            0xDC => count32 <= 4 * maxValues ? 64 + count32 : null,
            _ => Floats(isMotion && bytes[at + 4] == 1 ? count16 : count32, maxValues),
        };
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

    private static PacketKind KindOf(byte first, byte second) => (first, second) switch
    {
        (0xFF, 0xDD) => PacketKind.Motion,
        (0xFF, 0x88) => PacketKind.Calculation,
        (0xFF, 0xAA) => PacketKind.Command,
        (0xCF, 0xDC) => PacketKind.StudioCalculation,
        _ => PacketKind.None,
    };
}
