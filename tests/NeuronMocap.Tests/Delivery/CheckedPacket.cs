using System.Buffers.Binary;
using NeuronMocap.Protocol;

namespace NeuronMocap.Tests.Delivery;

/// <summary>Packets that prove their own integrity: number, length and every byte follow from each other.</summary>
internal static class CheckedPacket
{
    private const int Smallest = 8;
    private const int Largest = 6_000;

    /// <summary>Writes packet number n. Its size differs from that of its neighbours by kilobytes.</summary>
    public static ReceivedPacket Write(byte[] buffer, int number)
    {
        int size = SizeOf(number);
        Span<byte> bytes = buffer.AsSpan(0, size);
        bytes.Fill(FillingOf(number));
        BinaryPrimitives.WriteInt32LittleEndian(bytes, number);
        bytes[^1] = (byte)~FillingOf(number);
        return new ReceivedPacket(PacketKind.Motion, new ArraySegment<byte>(buffer, 0, size), timestamp: -number, origin: number % 7);
    }

    public static byte[] CreateBuffer() => new byte[Largest];

    /// <summary>Asserts that all parts of a packet belong to one number.</summary>
    /// <returns>The number.</returns>
    public static int Check(in ReceivedPacket packet)
    {
        ReadOnlySpan<byte> bytes = packet.Bytes;
        int number = BinaryPrimitives.ReadInt32LittleEndian(bytes);
        bool isWhole = bytes.Length == SizeOf(number)
            && (packet.Timestamp, packet.Sender) == (-number, number % 7)
            && bytes[4..^1].IndexOfAnyExcept(FillingOf(number)) < 0
            && bytes[^1] == (byte)~FillingOf(number);
        if (!isWhole)
            Assert.Fail($"Packet {number} of {bytes.Length} bytes is torn.");

        return number;
    }

    private static int SizeOf(int number) => Smallest + (int)((uint)number * 2_654_435_761 % (Largest - Smallest));

    private static byte FillingOf(int number) => (byte)((uint)number * 40_503 >> 8);
}
