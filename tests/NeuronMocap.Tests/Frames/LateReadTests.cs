using NeuronMocap.Delivery;
using NeuronMocap.Frames;
using NeuronMocap.Protocol;
using NeuronMocap.Recording;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Network;
using NeuronMocap.Tests.Playback;

namespace NeuronMocap.Tests.Frames;

/// <summary>Reading a reused frame too late throws, for every member and every way of delivery. It never shows another frame's data.</summary>
public sealed class LateReadTests
{
    public static TheoryData<PacketKind> Kinds => [PacketKind.Motion, PacketKind.Calculation, PacketKind.StudioCalculation];

    [Theory, MemberData(nameof(Kinds))]
    public void Every_member_reads_a_frame_in_its_handler_and_throws_after_it(PacketKind kind)
    {
        AvatarFrame? kept = null;
        List<Exception?> inTime = [];
        var queue = new FrameQueue(4, SkeletonFormat.Default, _ => { });
        Publish(queue, kind, 1);
        Pump(queue, frame =>
        {
            kept = frame;
            inTime.AddRange(FrameMembers.Of(frame.GetType()).Select(member => Record.Exception(() => member.Read(frame))));
        });

        Assert.DoesNotContain(inTime, static exception => exception is InvalidOperationException);
        Assert.NotEmpty(FrameMembers.Of(kept!.GetType()));
        foreach ((string name, Action<AvatarFrame> read) in FrameMembers.Of(kept.GetType()))
            AssertLate(Record.Exception(() => read(kept)), name);
    }

    [Theory, MemberData(nameof(Kinds))]
    public void A_frame_is_valid_for_all_handlers_of_a_callback(PacketKind kind)
    {
        var callbacks = new FrameCallbacks(SkeletonFormat.Default, _ => { }, new HandlerThread());
        List<AvatarFrame> kept = [];
        List<uint?> seen = [];
        Add(callbacks, kept.Add);
        Add(callbacks, _ => throw new FormatException());
        Add(callbacks, frame => seen.Add(frame.FrameIndex));
        callbacks.OnPacket(Packet(kind, 1));
        callbacks.OnPacket(Packet(kind, 2));

        Assert.Equal([1u, 2u], seen);
        Assert.Equal(2, kept.Count);
        Assert.All(kept, static frame => AssertLate(frame));
    }

    [Theory, MemberData(nameof(Kinds))]
    public void The_previous_frame_is_invalid_during_the_next_callback(PacketKind kind)
    {
        var queue = new FrameQueue(128, SkeletonFormat.Default, _ => { });
        for (int i = 0; i < 100; i++)
            Publish(queue, kind, i);

        AvatarFrame? previous = null;
        int compared = 0;
        Pump(queue, frame =>
        {
            if (previous is not null)
            {
                AssertLate(previous);
                compared++;
            }

            previous = frame;
        });
        Assert.Equal(99, compared);
    }

    [Fact]
    public void Kept_frames_never_show_a_newer_frame()
    {
        for (int avatars = 1; avatars < FramePool.OfHandlers; avatars++)
        {
            var queue = new FrameQueue(1024, SkeletonFormat.Default, _ => { });
            var kept = new MotionFrame?[avatars];
            for (int i = 0; i < avatars * 8; i++)
                Publish(queue, PacketKind.Motion, i, i % avatars);

            queue.Pump<MotionFrame>(frame =>
            {
                ref MotionFrame? last = ref kept[frame.AvatarIndex];
                if (last is not null)
                    AssertLate(last);

                last = frame;
            });
        }
    }

    [Fact]
    public void A_frame_read_late_is_never_reused()
    {
        var queue = new FrameQueue(1024, SkeletonFormat.Default, _ => { });
        for (int i = 0; i < 500; i++)
            Publish(queue, PacketKind.Motion, i);

        MotionFrame? kept = null;
        queue.Pump<MotionFrame>(frame => kept = frame, maxFrames: 1);
        AssertLate(kept!);
        queue.Pump<MotionFrame>(frame =>
        {
            Assert.NotSame(kept, frame);
            AssertLate(kept!);
        });
    }

    [Fact]
    public async Task A_frame_captured_by_a_task_is_invalid()
    {
        var queue = new FrameQueue(4, SkeletonFormat.Default, _ => { });
        Publish(queue, PacketKind.Motion, 1);
        using var handled = new SemaphoreSlim(0);
        Task? late = null;
        queue.Pump<MotionFrame>(frame => late = ReadLaterAsync(frame));
        handled.Release();
        AssertLate(await Record.ExceptionAsync(() => late!), nameof(MotionFrame.Values));

        async Task ReadLaterAsync(MotionFrame frame)
        {
            Assert.Equal(1u, frame.FrameIndex);
            await handled.WaitAsync();
            _ = frame.Values.Length;
        }
    }

    [Fact]
    public void A_frame_is_invalid_after_a_throwing_handler()
    {
        var queue = new FrameQueue(4, SkeletonFormat.Default, _ => { });
        Publish(queue, PacketKind.Motion, 1);
        MotionFrame? kept = null;
        Assert.Throws<FormatException>(() => queue.Pump<MotionFrame>(frame =>
        {
            kept = frame;
            throw new FormatException();
        }));
        AssertLate(kept!);
    }

    [Fact]
    public void A_handler_that_pumps_another_queue_keeps_its_own_frame()
    {
        var outer = new FrameQueue(4, SkeletonFormat.Default, _ => { });
        var inner = new FrameQueue(4, SkeletonFormat.Default, _ => { });
        Publish(outer, PacketKind.Motion, 1);
        Publish(inner, PacketKind.Motion, 2);
        outer.Pump<MotionFrame>(frame =>
        {
            MotionFrame? other = null;
            inner.Pump<MotionFrame>(lent =>
            {
                other = lent;
                Assert.Equal((1u, 2u), (frame.FrameIndex, lent.FrameIndex));
            });
            Assert.Equal(1u, frame.FrameIndex);
            AssertLate(other!);
        });
    }

    [Theory, MemberData(nameof(Kinds))]
    public void A_latest_frame_is_valid_until_the_next_is_taken(PacketKind kind)
    {
        var latest = new LatestFrames(SkeletonFormat.Default, _ => { });
        ((IPacketConsumer)latest).OnPacket(Packet(kind, 1));
        AvatarFrame first = Take(latest, kind)!;
        Assert.Null(Take(latest, kind));
        ((IPacketConsumer)latest).OnPacket(Packet(kind, 2));
        Assert.Equal(1u, first.FrameIndex);

        AvatarFrame second = Take(latest, kind)!;
        Assert.Equal(2u, second.FrameIndex);
        AssertLate(first);
        latest.Dispose();
        Assert.Equal(2u, second.FrameIndex);
    }

    [Fact]
    public void A_frame_of_a_file_is_valid_until_the_next_read()
    {
        using TemporaryFile file = Playback.Recordings.OfTcp(
            (1, TestPackets.Join(TestPackets.Motion(1), TestPackets.Calculation(2))), (2, TestPackets.Studio(3)));
        using RecordedFrameReader reader = RecordedFrameReader.Open(file.Path);
        List<AvatarFrame> kept = [];
        while (reader.Read())
        {
            Assert.All(kept, static frame => AssertLate(frame));
            Assert.Equal((uint)kept.Count + 1, reader.Frame.FrameIndex);
            kept.Add(reader.Frame);
        }

        Assert.Equal(3, kept.Count);
        Assert.All(kept, static frame => AssertLate(frame));
    }

    [Theory, MemberData(nameof(Kinds))]
    public void A_clone_is_always_valid(PacketKind kind)
    {
        var queue = new FrameQueue(4, SkeletonFormat.Default, _ => { });
        Publish(queue, kind, 7);
        AvatarFrame? clone = null;
        Pump(queue, frame => clone = frame.Clone());
        Assert.Equal(7u, clone!.FrameIndex);
        foreach ((_, Action<AvatarFrame> read) in FrameMembers.Of(clone.GetType()))
            Assert.IsNotType<InvalidOperationException>(Record.Exception(() => read(clone)));
        Assert.Equal(7u, clone.Clone().FrameIndex);
    }

    [Fact]
    public async Task Frames_of_a_reader_are_invalid_after_their_handlers()
    {
        using var server = new TestServer();
        using var reader = new NeuronReader(server.Options());
        using FrameQueue queue = reader.OpenQueue();
        MotionFrame? received = null;
        reader.MotionReceived += frame => Volatile.Write(ref received, frame);
        reader.Start();
        using TestConnection connection = await server.AcceptAsync();
        await connection.SendAsync(TestPackets.Motion(1));
        await reader.WaitForFramesAsync(1);
        reader.Dispose();

        AssertLate(received!);
        MotionFrame? pumped = null;
        Assert.Equal(1, queue.Pump<MotionFrame>(frame => pumped = frame));
        AssertLate(pumped!);
    }

    [Fact]
    public async Task Enumerated_frames_stay_valid()
    {
        using var server = new TestServer();
        using var reader = new NeuronReader(server.Options());
        await using IAsyncEnumerator<MotionFrame> frames = reader.ReadMotionAsync().GetAsyncEnumerator();
        ValueTask<bool> first = frames.MoveNextAsync();
        using TestConnection connection = await server.AcceptAsync();
        await connection.SendAsync(TestPackets.Motions(0, 40));
        Assert.True(await first);
        List<MotionFrame> kept = [frames.Current];
        while (kept.Count < 40 && await frames.MoveNextAsync())
            kept.Add(frames.Current);

        Assert.Equal(Enumerable.Range(0, 40).Select(static index => (uint?)index), kept.Select(static frame => frame.FrameIndex));
    }

    private static ReceivedPacket Packet(PacketKind kind, int frame, int avatar = 0) => new(
        kind,
        kind switch
        {
            PacketKind.Motion => TestPackets.Motion(frame, avatar),
            PacketKind.Calculation => TestPackets.Calculation(frame, avatar),
            _ => TestPackets.Studio(frame, avatar),
        },
        timestamp: 0,
        origin: 0);

    private static void Publish(FrameQueue queue, PacketKind kind, int frame, int avatar = 0) =>
        ((IPacketConsumer)queue).OnPacket(Packet(kind, frame, avatar));

    private static void Pump(FrameQueue queue, Action<AvatarFrame> handler) => queue.Pump(handler);

    private static void Add(FrameCallbacks callbacks, Action<AvatarFrame> handler)
    {
        callbacks.Motion.Add(handler);
        callbacks.Calculation.Add(handler);
        callbacks.StudioCalculation.Add(handler);
    }

    private static AvatarFrame? Take(LatestFrames latest, PacketKind kind) => kind switch
    {
        PacketKind.Motion => latest.TryTakeMotion(0, out MotionFrame? motion) ? motion : null,
        PacketKind.Calculation => latest.TryTakeCalculation(0, out CalculationFrame? calculation) ? calculation : null,
        _ => latest.TryTakeStudioCalculation(0, out StudioCalculationFrame? studio) ? studio : null,
    };

    private static void AssertLate(AvatarFrame frame) => AssertLate(Record.Exception(() => frame.FrameIndex), nameof(AvatarFrame.FrameIndex));

    private static void AssertLate(Exception? exception, string member)
    {
        var late = Assert.IsType<InvalidOperationException>(exception);
        Assert.True(late.Message.Contains("Clone()", StringComparison.Ordinal), member);
    }
}
