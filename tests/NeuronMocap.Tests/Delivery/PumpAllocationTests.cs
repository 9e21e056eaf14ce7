using NeuronMocap.Delivery;
using NeuronMocap.Protocol;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Delivery;

/// <summary>Exact allocations on the thread that takes frames.</summary>
public sealed class PumpAllocationTests
{
    private const int Rounds = 100;

    private static readonly byte[] Packet = TestPackets.Motion(1);
    private readonly FrameQueue _queue = new(64, SkeletonFormat.Default, _ => { });
    private float _sum;

    [Fact]
    public void A_pump_with_a_state_allocates_nothing()
    {
        AssertBytes(0, () =>
        {
            Publish(3);
            _queue.Pump(this, static (PumpAllocationTests self, AvatarFrame frame) => self._sum += frame.Values[0]);
        });
        Assert.NotEqual(0, _sum);
    }

    [Fact]
    public void A_pump_with_several_values_as_its_state_allocates_nothing()
    {
        float[] sums = new float[1];
        AssertBytes(0, () =>
        {
            Publish(1);
            _queue.Pump((sums, Factor: 2f), static ((float[] sums, float Factor) state, MotionFrame frame) => state.sums[0] += frame.Values[0] * state.Factor);
        });
        Assert.NotEqual(0, sums[0]);
    }

    [Fact]
    public void Handlers_of_each_kind_get_the_state()
    {
        ((IPacketConsumer)_queue).OnPacket(new ReceivedPacket(PacketKind.Motion, TestPackets.Motion(1), 0, 0));
        ((IPacketConsumer)_queue).OnPacket(new ReceivedPacket(PacketKind.Calculation, TestPackets.Calculation(2), 0, 0));
        ((IPacketConsumer)_queue).OnPacket(new ReceivedPacket(PacketKind.StudioCalculation, TestPackets.Studio(3), 0, 0));
        ((IPacketConsumer)_queue).OnPacket(new ReceivedPacket(PacketKind.Motion, TestPackets.Motion(4), 0, 0));
        List<string> seen = [];
        int taken = _queue.Pump(
            seen,
            static (List<string> list, AvatarFrame frame) => list.Add($"{frame.GetType().Name} {frame.FrameIndex}"),
            maxFrames: 3);

        Assert.Equal(3, taken);
        Assert.Equal(["MotionFrame 1", "CalculationFrame 2", "StudioCalculationFrame 3"], seen);
        Assert.Equal(1, _queue.Pump(seen, static (List<string> list, CalculationFrame frame) => list.Add("another kind")));
        Assert.Equal((3, 4L, 0), (seen.Count, _queue.Delivered, _queue.Count));
    }

    [Fact]
    public void Enumerating_allocates_only_the_copies()
    {
        var stream = new FrameStream(_queue);
        var frame = new MotionFrame(SkeletonFormat.Default);
        frame.Borrow(new ReceivedPacket(PacketKind.Motion, Packet, 0, 0));
        long clone = Measure(() => GC.KeepAlive(frame.Clone()));
        float before = _sum;
        AssertBytes(20 * clone, () =>
        {
            Publish(20);
            for (int i = 0; i < 20; i++)
            {
                ValueTask<AvatarFrame?> read = stream.ReadAsync(CancellationToken.None);
                if (read.IsCompletedSuccessfully)
                    _sum += read.Result!.Values[0];
            }
        });
        Assert.Equal(before + (Rounds * 20 * frame.Values[0]), _sum);
    }

    [Fact]
    public void TryGet_without_a_frame_allocates_nothing()
    {
        var stream = new FrameStream(_queue);
        AssertBytes(0, () => _sum += stream.TryRead() is null ? 1 : 0);
        Assert.Equal(Rounds, _sum);
    }

    private static void AssertBytes(long expected, Action action) => Assert.Equal(expected, Measure(action));

    // The minimum of many calls, because the first calls create lasting objects and compile.
    private static long Measure(Action action)
    {
        long least = long.MaxValue;
        for (int i = 0; i < Rounds; i++)
        {
            long before = GC.GetAllocatedBytesForCurrentThread();
            action();
            least = Math.Min(least, GC.GetAllocatedBytesForCurrentThread() - before);
        }

        return least;
    }

    private void Publish(int count)
    {
        for (int i = 0; i < count; i++)
            ((IPacketConsumer)_queue).OnPacket(new ReceivedPacket(PacketKind.Motion, Packet, 0, 0));
    }
}
