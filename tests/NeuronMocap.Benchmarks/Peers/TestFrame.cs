using System.Buffers.Binary;
using NeuronMocap.Protocol;

namespace NeuronMocap.Benchmarks.Peers;

// A motion packet with displacement: 354 values, 1480 bytes. The first eight bytes of its values carry a time stamp where one is asked for.
internal static class TestFrame
{
    public const int Size = 1480;

    public const int HeaderSize = ProtocolConstants.HeaderSize;

    private const int IndexOffset = 46;

    public static byte[] Create(int avatar = 0)
    {
        byte[] packet = new byte[Size];
        var header = new MotionHeader { HasDisplacement = true, AvatarIndex = (uint)avatar, AvatarName = new AvatarName($"Char{avatar:00}") };
        PacketEncoder.WriteMotion(packet, header, new float[354]);
        return packet;
    }

    public static void SetIndex(Span<byte> packet, uint index) => BinaryPrimitives.WriteUInt32LittleEndian(packet[IndexOffset..], index);

    public static void SetTime(Span<byte> packet, long ticks) => BinaryPrimitives.WriteInt64LittleEndian(packet[HeaderSize..], ticks);

    public static long GetTime(ReadOnlySpan<byte> values) => BinaryPrimitives.ReadInt64LittleEndian(values);
}
