using System.Globalization;
using System.Runtime.InteropServices;
using System.Text;
using NeuronMocap.Protocol;

namespace NeuronMocap.Tests.Network;

// Packets whose values identify their place: value i of frame n of avatar a is n + a / 8 + i / 1024, exact in binary32.
internal static class TestPackets
{
    public static float Value(int frame, int avatar, int index) => frame + (avatar / 8f) + (index / 1024f);

    public static byte[] Motion(int frame, int avatar = 0, int count = 354, string name = "Char00", HeaderLayout layout = HeaderLayout.New)
    {
        var header = new MotionHeader
        {
            Version = layout == HeaderLayout.New ? DataVersion.New : DataVersion.Old,
            AvatarIndex = avatar,
            AvatarName = new AvatarName(name),
            FrameIndex = layout == HeaderLayout.New ? (uint)frame : null,
            HasDisplacement = count >= 354,
            HasReference = count is 186 or 360,
        };
        byte[] packet = new byte[64 + (4 * count)];
        PacketEncoder.WriteMotion(packet, header, Values(frame, avatar, count));
        return packet;
    }

    public static byte[] Calculation(int frame, int avatar = 0, int count = 946)
    {
        var header = new CalculationHeader { AvatarIndex = avatar, AvatarName = new AvatarName("Char00"), FrameIndex = (uint)frame };
        byte[] packet = new byte[64 + (4 * count)];
        PacketEncoder.WriteCalculation(packet, header, Values(frame, avatar, count));
        return packet;
    }

    // A frame's line. Each value has as many digits as it needs to be exact.
    public static byte[] Line(int frame, int avatar = 0, int count = 354, string? lead = null, string separator = " ", string end = " ||\r\n") =>
        Encoding.UTF8.GetBytes((lead ?? $"{avatar} Char00 ") + string.Join(separator, Values(frame, avatar, count).Select(
            static value => value.ToString("R", CultureInfo.InvariantCulture))) + end);

    public static byte[] Studio(int frame, int avatar = 0, int bones = 59, uint mask = StudioCalculationHeader.FullDataMask)
    {
        byte[] payload = new byte[bones * 84];
        Values(frame, avatar, bones * 21).CopyTo(MemoryMarshal.Cast<byte, float>(payload.AsSpan()));
        byte[] packet = new byte[64 + payload.Length];
        var header = new StudioCalculationHeader
        {
            AvatarIndex = avatar,
            AvatarName = new AvatarName("Char00"),
            FrameIndex = (uint)frame,
            DataMask = mask,
        };
        PacketEncoder.WriteStudioCalculation(packet, header, payload);
        return packet;
    }

    public static byte[] Join(params IEnumerable<byte[]> packets) => [.. packets.SelectMany(static packet => packet)];

    public static byte[] Motions(int first, int count) => Join(Enumerable.Range(first, count).Select(static frame => Motion(frame)));

    private static float[] Values(int frame, int avatar, int count) =>
        [.. Enumerable.Range(0, count).Select(index => Value(frame, avatar, index))];
}
