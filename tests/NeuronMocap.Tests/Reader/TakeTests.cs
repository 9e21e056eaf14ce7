using NeuronMocap.Bvh;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Server.Sources;

namespace NeuronMocap.Tests.Reader;

// A take, broadcast and received over real TCP: every frame, every float.
public class TakeTests
{
    /// <summary>Loads the take. Derived classes load a recorded take.</summary>
    internal virtual BvhDocument Load() => BvhDocument.Parse(NeuronTake.Write(600));

    [Theory]
    [InlineData(null)]
    [InlineData(1)]
    [InlineData(7)]
    [InlineData(1480)]
    [InlineData(1481)]
    [InlineData(65_536)]
    public async Task Every_value_of_the_file_arrives_in_any_pieces(int? fragment)
    {
        BvhDocument take = Load();

        // A call to the system for each byte of a long take would take seconds, and every place is split in each frame.
        int frames = fragment == 1 ? 100 : take.FrameCount;
        await using var broadcaster = new Broadcaster(new BroadcasterOptions
        {
            Sources = [new BvhSource(take)],
            Port = 0,
            FrameRate = BroadcasterOptions.MaxFrameRate,
            MaxFrames = frames,
            WaitForClient = true,
            Fragment = fragment,
        });
        broadcaster.Start();

        // The file's rows are the values of packets without displacement, in the same order.
        int row = 0;
        await using NeuronReader reader = Connect(broadcaster);
        reader.MotionReceived += frame =>
        {
            Assert.Equal((uint)row, frame.FrameIndex);
            AssertSameBits(take.GetValues(row++), frame.Values);
        };
        await ReceiveAllAsync(reader);
        Assert.Equal(frames, row);
        await broadcaster.Completion.Soon();
    }

    [Fact]
    public async Task Positions_with_displacement_are_the_files_offsets()
    {
        BvhDocument take = Load();
        await using var broadcaster = new Broadcaster(new BroadcasterOptions
        {
            Sources = [new BvhSource(take)],
            Port = 0,
            FrameRate = BroadcasterOptions.MaxFrameRate,
            IncludeDisplacement = true,
            IncludeReference = true,
        });
        broadcaster.Start();
        await using NeuronReader reader = Connect(broadcaster);
        int row = 0;
        reader.MotionReceived += frame =>
        {
            ReadOnlySpan<float> expected = take.GetValues(row++);
            AssertSameBits([0, 0, 0, 0, 0, 0], frame.Values[..6]);
            AssertSameBits(expected[..6], frame.Values[6..12]);
            for (int bone = 1; bone < BoneHierarchy.BoneCount; bone++)
            {
                BvhJoint joint = take.Joints[bone];
                AssertSameBits([joint.Offset.X, joint.Offset.Y, joint.Offset.Z], frame.Values.Slice(6 + (bone * 6), 3));
                AssertSameBits(expected.Slice(3 + (bone * 3), 3), frame.Values.Slice(9 + (bone * 6), 3));
            }
        };
        await ReceiveAllAsync(reader);
        Assert.Equal(take.FrameCount, row);
    }

    [Fact]
    public async Task Two_avatars_with_calculation_data_arrive_in_step()
    {
        BvhDocument take = Load();
        var source = new BvhSource(take);
        await using var broadcaster = new Broadcaster(new BroadcasterOptions
        {
            Sources = [source, source],
            Port = 0,
            FrameRate = BroadcasterOptions.MaxFrameRate,
            Calculation = CalculationSynthesizer.Write,
            MaxFrames = 200,
        });
        broadcaster.Start();
        await using NeuronReader reader = Connect(broadcaster);
        List<string> order = [];
        int contacts = 0;
        reader.MotionReceived += frame => order.Add($"{frame.FrameIndex}.{frame.AvatarIndex}");
        reader.CalculationReceived += frame =>
        {
            Assert.Equal(order[^1], $"{frame.FrameIndex}.{frame.AvatarIndex}");
            contacts += frame.LeftFootContact && frame.RightFootContact ? 1 : 0;
        };
        await ReceiveAllAsync(reader);
        Assert.Equal(Enumerable.Range(0, 200).SelectMany(frame => new[] { $"{frame}.0", $"{frame}.1" }), order);
        Assert.Equal(2 * Enumerable.Range(0, 200).Count(frame => source.GetFootContacts(frame) is { Left: true, Right: true }), contacts);
    }

    private static NeuronReader Connect(Broadcaster broadcaster) => new(new NeuronReaderOptions
    {
        Port = broadcaster.LocalEndPoint!.Port,
        RotationOrder = RotationOrder.YXZ,
        SkeletonVariant = SkeletonVariant.Spine3,
        Reconnect = { Enabled = false },
    });

    private static async Task ReceiveAllAsync(NeuronReader reader)
    {
        List<Exception> failures = [];
        reader.CallbackFailed += failures.Add;
        reader.Start();
        await reader.Completion.Soon();
        Assert.Empty(failures);
        ReaderStatistics statistics = reader.GetStatistics();
        Assert.Equal((0L, 0L, 0L), (statistics.Lost, statistics.Dropped, statistics.BytesSkipped));
    }

    private static void AssertSameBits(ReadOnlySpan<float> expected, ReadOnlySpan<float> actual) =>
        Assert.True(System.Runtime.InteropServices.MemoryMarshal.AsBytes(expected).SequenceEqual(System.Runtime.InteropServices.MemoryMarshal.AsBytes(actual)));
}
