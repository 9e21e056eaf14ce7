using System.Runtime.InteropServices;
using NeuronMocap.Protocol;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Server;

// The expected packets of a broadcast, from the options and the source alone.
internal static class Expect
{
    // Options for a broadcast of test sources on a free port.
    public static BroadcasterOptions Options(int avatars = 1, long? frames = null) => new()
    {
        Sources = [.. Enumerable.Range(0, avatars).Select(avatar => new TestSource(avatar, frames))],
        Port = 0,
        FrameRate = BroadcasterOptions.MaxFrameRate,
        CloseTimeout = Limits.Unexpected,
    };

    // The frames from first on, complete and in order: for each avatar a motion packet and, on request, a calculation packet.
    public static void Frames(IReadOnlyList<byte[]> packets, BroadcasterOptions options, long count, long first = 0)
    {
        int perAvatar = options.Calculation is null && options.StudioCalculation is null ? 1 : 2;
        Assert.Equal(count * options.Sources.Count * perAvatar, packets.Count);
        int index = 0;
        for (long frame = first; frame < first + count; frame++)
        {
            for (int avatar = 0; avatar < options.Sources.Count; avatar++)
            {
                Motion(packets[index++], options, avatar, frame);
                if (options.Calculation is not null)
                    Calculation(packets[index++], options, avatar, frame);
                if (options.StudioCalculation is not null)
                    StudioCalculation(packets[index++], options, avatar, frame);
            }
        }
    }

    // The packets on the motion port if calculation data has its own port.
    public static void MotionFrames(IReadOnlyList<byte[]> packets, BroadcasterOptions options, long count) =>
        All(packets, options, count, Motion);

    // The packets on a port without motion.
    public static void CalculationFrames(IReadOnlyList<byte[]> packets, BroadcasterOptions options, long count) =>
        All(packets, options, count, options.StudioCalculation is null ? Calculation : StudioCalculation);

    public static void Motion(byte[] packet, BroadcasterOptions options, int avatar, long frame)
    {
        var layout = new ChannelLayout(options.IncludeDisplacement ?? true, options.IncludeReference);
        DataVersion version = options.DataVersion ?? (options.Format == BroadcastFormat.Studio ? DataVersion.Studio : DataVersion.New);
        bool isNew = version.Minor == 1;
        string name = options.AvatarNames.Count > avatar ? options.AvatarNames[avatar] : $"Char{avatar:00}";
        Assert.True(MotionHeader.TryRead(packet, out MotionHeader header));
        byte[] expectedHeader = new byte[ProtocolConstants.HeaderSize];
        new MotionHeader
        {
            Version = version,
            ValueCount = layout.ValueCount,
            HasDisplacement = layout.HasDisplacement,
            HasReference = layout.HasReference,
            AvatarIndex = avatar,
            AvatarName = new AvatarName(name),
            FrameIndex = isNew ? (uint)frame : null,
            Reserved = version == DataVersion.Studio ? (uint)options.RotationOrder : 0,

            // The timecode has tests of its own.
            Reserved1 = options.Format == BroadcastFormat.Studio ? header.Reserved1 : 0,
            Reserved2 = options.Format == BroadcastFormat.Studio ? header.Reserved2 : 0,
        }.Write(expectedHeader);
        Assert.Equal(expectedHeader, packet[..ProtocolConstants.HeaderSize]);
        float[] expected = new float[layout.ValueCount];
        options.Sources[avatar].WriteValues(frame, layout, options.RotationOrder, expected);
        AssertBits(expected, packet);
    }

    public static void Calculation(byte[] packet, BroadcasterOptions options, int avatar, long frame)
    {
        Assert.True(CalculationHeader.TryRead(packet, out CalculationHeader header));
        Assert.Equal(options.CalculationValueCount, header.ValueCount);
        Assert.Equal(avatar, header.AvatarIndex);
        Assert.Equal((uint)frame, header.FrameIndex);
        Assert.Equal($"Char{avatar:00}", header.AvatarName.ToString());
        float[] expected = new float[946];
        options.Calculation!(options.Sources[avatar], frame, expected);
        AssertBits(expected.AsSpan(0, options.CalculationValueCount), packet);
    }

    public static void StudioCalculation(byte[] packet, BroadcasterOptions options, int avatar, long frame)
    {
        Assert.True(StudioCalculationHeader.TryRead(packet, out StudioCalculationHeader header));
        Assert.Equal((4956, 5020), (header.ByteCount, packet.Length));
        Assert.Equal((avatar, (uint)frame, 0xFEu), (header.AvatarIndex, header.FrameIndex, header.DataMask));
        Assert.Equal((DataVersion.StudioCalculation, $"Char{avatar:00}"), (header.Version, header.AvatarName.ToString()));
        byte[] expected = new byte[4956];
        options.StudioCalculation!(options.Sources[avatar], frame, expected);
        Assert.Equal(expected, packet[64..]);
    }

    public static uint FrameIndex(byte[] packet)
    {
        Assert.True(MotionHeader.TryRead(packet, out MotionHeader header));
        return Assert.NotNull(header.FrameIndex);
    }

    private static void All(IReadOnlyList<byte[]> packets, BroadcasterOptions options, long count, Action<byte[], BroadcasterOptions, int, long> check)
    {
        int avatars = options.Sources.Count;
        Assert.Equal(count * avatars, packets.Count);
        for (int i = 0; i < packets.Count; i++)
            check(packets[i], options, i % avatars, i / avatars);
    }

    // Compared as bytes: two NaN values are equal only if their bits are.
    private static void AssertBits(ReadOnlySpan<float> expected, byte[] packet) =>
        Assert.True(MemoryMarshal.AsBytes(expected).SequenceEqual(packet.AsSpan(ProtocolConstants.HeaderSize)));
}
