using System.Buffers.Binary;
using NeuronMocap.Protocol;

namespace NeuronMocap.Benchmarks.Peers;

// A motion packet with displacement: 354 values, 1480 bytes. On request, the first eight bytes of its values carry a time stamp.
internal static class TestFrame
{
    public const int Size = 1480;

    public const int HeaderSize = ProtocolConstants.HeaderSize;

    public const int IndexOffset = 46;

    // values: a number that determines the values. 0 leaves them all zero.
    public static byte[] Create(int avatar = 0, int values = 0)
    {
        byte[] packet = new byte[Size];
        var header = new MotionHeader { HasDisplacement = true, AvatarIndex = avatar, AvatarName = new AvatarName($"Char{avatar:00}") };
        PacketEncoder.WriteMotion(packet, header, [.. Enumerable.Range(0, 354).Select(i => values * MathF.Sin(values + i))]);
        return packet;
    }

    public static void SetIndex(Span<byte> packet, uint index) => BinaryPrimitives.WriteUInt32LittleEndian(packet[IndexOffset..], index);

    // What the index adds to the sum of all 32-bit words. Its halves are in two of them.
    public static ulong SumOfIndex(uint index) => ((ulong)(index & 0xFFFF) << 16) + (index >> 16);

    public static void SetTime(Span<byte> packet, long ticks) => BinaryPrimitives.WriteInt64LittleEndian(packet[HeaderSize..], ticks);

    public static long GetTime(ReadOnlySpan<byte> values) => BinaryPrimitives.ReadInt64LittleEndian(values);
}
