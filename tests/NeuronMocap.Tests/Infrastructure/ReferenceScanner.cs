using NeuronMocap.Protocol;

namespace NeuronMocap.Tests.Infrastructure;

/// <summary>
/// The rules of the stream, told slowly and over the whole of the bytes at once: what <see cref="PacketScanner"/> is compared with.
/// </summary>
internal static class ReferenceScanner
{
    public static (List<FoundPacket> Packets, long Skipped, int Pending) Read(byte[] bytes, int maxValues = 10_224)
    {
        List<FoundPacket> packets = [];
        long skipped = 0;
        int at = 0;
        while (at < bytes.Length)
        {
            long? size = PacketSizeAt(bytes, at, maxValues);
            if (size is null)
            {
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
                at += (int)size;
            }
        }

        return (packets, skipped, bytes.Length - at);
    }

    // The size of the packet that starts or may start here; null where none can.
    private static long? PacketSizeAt(byte[] bytes, int at, int maxValues)
    {
        int left = bytes.Length - at;
        if (bytes[at] != 0xFF)
            return null;
        if (left >= 2 && KindOf(bytes[at + 1]) == PacketKind.None)
            return null;
        if (left < 64)
            return 64;

        byte closing = bytes[at + 1] switch { 0xDD => 0xEE, 0x88 => 0x99, _ => 0xBB };
        if (bytes[at + 62] != 0xFF || bytes[at + 63] != closing)
            return null;

        long count16 = bytes[at + 6] + (256L * bytes[at + 7]);
        long count32 = count16 + (65536L * bytes[at + 8]) + (16777216L * bytes[at + 9]);
        switch (bytes[at + 1])
        {
            case 0x88:
                return Floats(count32, maxValues);
            case 0xAA:
                return CommandSize(bytes.AsSpan(at, 64));
            default:
                return (bytes[at + 5], bytes[at + 4]) switch
                {
                    (1, 0) => Floats(count32, maxValues),
                    (1, 1) => Floats(count16, maxValues),
                    _ => null,
                };
        }
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
