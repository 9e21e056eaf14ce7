using System.Net;
using System.Numerics;
using System.Runtime.InteropServices;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Server.Sources;

namespace NeuronMocap.Tests.Reader;

// Every format of the broadcaster through a reader that is not told the format.
public sealed class FormatTests
{
    private const int Frames = 40;
    private const int Avatars = 2;

    private static readonly ChannelLayout Layout = new(hasDisplacement: true, hasReference: false);

    public static TheoryData<BroadcastFormat, bool, int?, bool> Ways { get; } = CreateWays();

    [Theory]
    [MemberData(nameof(Ways))]
    public async Task Every_frame_arrives_unchanged(BroadcastFormat format, bool isOld, int? fragment, bool isUdp)
    {
        BroadcasterOptions options = CreateOptions(format, isOld, fragment);
        NeuronReader? listening = isUdp ? await ListenAsync(options) : null;
        await using var broadcaster = new Broadcaster(options);
        using FrameQueue? early = listening?.OpenQueue();
        broadcaster.Start();
        await using NeuronReader reader = listening ?? new NeuronReader("127.0.0.1", broadcaster.LocalEndPoint!.Port);
        using FrameQueue queue = early ?? reader.OpenQueue();
        if (!isUdp)
            reader.Start();

        await Limits.UntilAsync(() => queue.Count >= Frames * Avatars * 2);
        Assert.Equal(Expected(format, isOld), reader.Status.Format);
        int motions = 0;
        int calculations = 0;
        queue.Pump<AvatarFrame>(
            frame =>
            {
                if (frame is MotionFrame motion)
                    AssertMotion(motion, options, motions++);
                else if (frame is CalculationFrame calculation)
                    AssertCalculation(calculation, options, calculations++, motions);
                else
                    AssertStudioCalculation((StudioCalculationFrame)frame, options, calculations++, motions);
            },
            Frames * Avatars * 2);
        Assert.Equal((Frames * Avatars, Frames * Avatars), (motions, calculations));
        Assert.Equal((0L, 0L), (reader.GetStatistics().BytesSkipped, reader.GetStatistics().Lost));
    }

    private static TheoryData<BroadcastFormat, bool, int?, bool> CreateWays()
    {
        var ways = new TheoryData<BroadcastFormat, bool, int?, bool>();
        foreach ((BroadcastFormat format, bool isOld) in new[]
            {
                (BroadcastFormat.Binary, false), (BroadcastFormat.Binary, true), (BroadcastFormat.Text, false), (BroadcastFormat.Studio, false),
            })
        {
            ways.Add(format, isOld, null, false);
            ways.Add(format, isOld, 7, false);
            ways.Add(format, isOld, null, true);
            ways.Add(format, isOld, 1024, true);
        }

        return ways;
    }

    private static BroadcasterOptions CreateOptions(BroadcastFormat format, bool isOld, int? fragment) => new()
    {
        Sources = [.. Enumerable.Range(0, Avatars).Select(avatar => new SyntheticSource(60, avatar))],
        Port = 0,
        FrameRate = 400,
        WaitForClient = true,
        QueueCapacity = 10_000,
        Format = format,
        DataVersion = isOld ? DataVersion.Old : null,
        RotationOrder = RotationOrder.YXZ,
        Calculation = format == BroadcastFormat.Studio ? null : CalculationSynthesizer.Write,
        StudioCalculation = format == BroadcastFormat.Studio ? StudioCalculationSynthesizer.Write : null,
        TextDecimals = 5,
        Fragment = fragment,
    };

    private static async Task<NeuronReader> ListenAsync(BroadcasterOptions options)
    {
        var reader = new NeuronReader(new NeuronReaderOptions { Transport = TransportKind.Udp, LocalAddress = IPAddress.Loopback, Port = 0 });
        await reader.StartAsync().Soon();
        (options.Port, options.WaitForClient, options.UdpDestinations) = (null, false, [(IPEndPoint)reader.Status.LocalEndPoint!]);
        return reader;
    }

    private static StreamFormat Expected(BroadcastFormat format, bool isOld) => format switch
    {
        BroadcastFormat.Text => StreamFormat.Text,
        BroadcastFormat.Studio => StreamFormat.Studio,
        _ => isOld ? StreamFormat.OldHeader : StreamFormat.Binary,
    };

    private static void AssertMotion(MotionFrame frame, BroadcasterOptions options, int index)
    {
        (int number, int avatar) = (index / Avatars, index % Avatars);
        float[] expected = new float[Layout.ValueCount];
        options.Sources[avatar].WriteValues(number, Layout, options.RotationOrder, expected);
        Assert.Equal((avatar, $"Char{avatar:00}"), (frame.AvatarIndex, frame.AvatarName));
        bool isNumbered = options.Format != BroadcastFormat.Text && options.DataVersion is null;
        Assert.Equal(isNumbered ? (uint)number : null, frame.FrameIndex);
        AssertClose(expected, frame.Values, options);

        // The time of the first frame is midnight, which looks the same as no time.
        Assert.Equal(options.Format == BroadcastFormat.Studio && number > 0 ? new Timecode(0, 0, 0, number) : null, frame.Timecode);
        if (options.Format == BroadcastFormat.Studio)
            Assert.Equal((uint)options.RotationOrder, frame.Header.Reserved);
    }

    // A line of text carries neither avatar nor frame number. Only its place shows them.
    private static void AssertCalculation(CalculationFrame frame, BroadcasterOptions options, int index, int motions)
    {
        Assert.Equal(index + 1, motions);
        float[] expected = new float[946];
        options.Calculation!(options.Sources[index % Avatars], index / Avatars, expected);
        AssertClose(expected, frame.Values, options);
        if (options.Format == BroadcastFormat.Text)
            Assert.Null(frame.FrameIndex);
        else
            Assert.Equal((index % Avatars, (uint)(index / Avatars)), (frame.AvatarIndex, frame.FrameIndex));
    }

    private static void AssertStudioCalculation(StudioCalculationFrame frame, BroadcasterOptions options, int index, int motions)
    {
        Assert.Equal(index + 1, motions);
        Assert.Equal((index % Avatars, (uint)(index / Avatars), $"Char{index % Avatars:00}"), (frame.AvatarIndex, frame.FrameIndex, frame.AvatarName));
        byte[] expected = new byte[StudioCalculationFrame.FullByteCount];
        options.StudioCalculation!(options.Sources[index % Avatars], index / Avatars, expected);
        Assert.True(frame.Payload.SequenceEqual(expected));

        BoneTransform[] world = ActorMeasures.GetWorld((SyntheticSource)options.Sources[index % Avatars], index / Avatars);
        foreach (Bone bone in BoneHierarchy.Bones)
        {
            Assert.True(Vector3.Distance(world[(int)bone].Position / 100, frame.GetPosition(bone)) < 1e-5f);
            Assert.True(ActorMeasures.Degrees(world[(int)bone].Rotation, frame.GetBoneRotation(bone)) < 1e-3);
            Assert.False(frame.IsSensorLost(bone));
        }
    }

    private static void AssertClose(ReadOnlySpan<float> expected, ReadOnlySpan<float> actual, BroadcasterOptions options)
    {
        Assert.Equal(expected.Length, actual.Length);
        if (MemoryMarshal.AsBytes(expected).SequenceEqual(MemoryMarshal.AsBytes(actual)))
            return;

        for (int i = 0; i < expected.Length; i++)
        {
            if (options.Format != BroadcastFormat.Text)
                Assert.Equal(BitConverter.SingleToInt32Bits(expected[i]), BitConverter.SingleToInt32Bits(actual[i]));
            else
                Assert.InRange(actual[i] - expected[i], -5e-5f, 5e-5f);
        }
    }
}
