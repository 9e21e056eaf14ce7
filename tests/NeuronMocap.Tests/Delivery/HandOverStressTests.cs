using System.Buffers.Binary;
using System.Diagnostics;
using NeuronMocap.Delivery;
using NeuronMocap.Protocol;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Network;
using NeuronMocap.Tests.Reader;

namespace NeuronMocap.Tests.Delivery;

/// <summary>The two places where packets change threads, with other threads competing for the processors.</summary>
[Collection(nameof(Alone))]
public sealed class HandOverStressTests
{
    private const int LeastTaken = 1_000;

    private static readonly TimeSpan LeastTime = TimeSpan.FromSeconds(0.35);

    // The number of packets that the consumer has taken.
    private int _taken;

    private delegate void Publish(in ReceivedPacket packet);

    private delegate bool TryTake(out ReceivedPacket packet);

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(64)]
    public async Task A_ring_keeps_every_packet_in_order(int capacity)
    {
        var ring = new PacketRing(capacity, slotSize: 16, firstIndex: int.MaxValue - 500);
        List<int> accepted = [];
        List<int> received = [];
        using (new Preemption())
        {
            Task producer = Produce((number, packet) =>
            {
                if (ring.TryEnqueue(packet))
                    accepted.Add(number);
            });
            var random = new Random(2);
            await Consume(producer, () =>
            {
                if (!ring.TryPeek(out ReceivedPacket packet))
                    return false;

                int number = CheckedPacket.Check(packet);
                Preemption.Stumble(random);
                Assert.Equal(number, CheckedPacket.Check(packet));
                received.Add(number);
                ring.Release();
                _taken++;
                return true;
            });
        }

        Assert.Equal(accepted, received);
        Assert.Equal(0, ring.Count);
    }

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(64)]
    public async Task A_ring_that_drops_its_oldest_never_overwrites_the_packet_that_is_read(int capacity)
    {
        var ring = new DroppingRing(capacity, slotSize: 16, firstIndex: int.MaxValue - 500);
        int stored = await PassRisingAsync(ring.Store, ring.TryTake);
        Assert.Equal((stored, _taken, 0), (ring.Taken + ring.Dropped, ring.Taken, ring.Count));
    }

    [Fact]
    public async Task The_newest_packet_is_never_torn_or_older()
    {
        var newest = new LatestPacket(slotSize: 16);
        await PassRisingAsync((in ReceivedPacket packet) => newest.Publish(packet), newest.TryTake);
    }

    [Fact]
    public async Task The_newest_frame_of_each_of_several_avatars_is_whole_and_never_older()
    {
        const int avatars = 6;
        byte[][] packets = [.. Enumerable.Range(0, 16 * avatars).Select(MakePacket)];
        using var latest = new LatestFrames(SkeletonFormat.Default, _ => { });
        uint[] published = new uint[avatars];
        uint[] last = new uint[avatars];
        using (new Preemption())
        {
            Task producer = Produce((number, _) =>
            {
                byte[] packet = packets[number % packets.Length];
                BinaryPrimitives.WriteInt32LittleEndian(packet.AsSpan(46), number);
                published[number % avatars] = (uint)number;
                ((IPacketConsumer)latest).OnPacket(new ReceivedPacket(IsMotion(number) ? PacketKind.Motion : PacketKind.Calculation, packet, 0, 0));
            });
            await Consume(producer, () =>
            {
                int before = _taken;
                for (int avatar = 0; avatar < avatars; avatar++)
                {
                    AvatarFrame? frame = null;
                    if (IsMotion(avatar) && latest.TryTakeMotion(avatar, out MotionFrame? motion))
                        frame = motion;
                    else if (!IsMotion(avatar) && latest.TryTakeCalculation(avatar, out CalculationFrame? calculation))
                        frame = calculation;
                    if (frame is null)
                        continue;

                    _taken++;
                    CheckFrame(frame, avatar, last[avatar]);
                    last[avatar] = frame.FrameIndex!.Value;
                }

                return _taken > before;
            });
        }

        Assert.Equal(published, last);

        static bool IsMotion(int number) => number % avatars < 4;

        static byte[] MakePacket(int number) => IsMotion(number)
            ? TestPackets.Motion(number, number % avatars, count: ((int[])[180, 354, 186, 360, 1])[number % 5])
            : TestPackets.Calculation(number, number % avatars, count: ((int[])[338, 946, 2])[number % 3]);

        void CheckFrame(AvatarFrame frame, int avatar, uint before)
        {
            uint index = frame.FrameIndex!.Value;
            int made = (int)(index % packets.Length);
            Assert.True(index > before && frame.AvatarIndex == avatar, $"Frame {index} of avatar {frame.AvatarIndex} after {before} of {avatar}.");
            Assert.Equal((packets[made].Length - 64) / sizeof(float), frame.Values.Length);
            for (int value = 0; value < frame.Values.Length; value++)
            {
                if (frame.Values[value] != TestPackets.Value(made, avatar, value))
                    Assert.Fail($"Value {value} of frame {index} is {frame.Values[value]}: another frame's.");
            }
        }
    }

    // Checks that packets arrive whole and in order, though not all of them, and that the last one arrives. Returns the number of the last one.
    private async Task<int> PassRisingAsync(Publish publish, TryTake tryTake)
    {
        int published = 0;
        int last = 0;
        using (new Preemption())
        {
            Task producer = Produce((number, packet) =>
            {
                publish(packet);
                published = number;
            });
            var random = new Random(2);
            await Consume(producer, () =>
            {
                if (!tryTake(out ReceivedPacket packet))
                    return false;

                int number = CheckedPacket.Check(packet);
                Assert.True(number > last, $"{number} after {last}");
                Preemption.Stumble(random);
                Assert.Equal(number, CheckedPacket.Check(packet));
                last = number;
                _taken++;
                return true;
            });
        }

        Assert.Equal(published, last);
        return published;
    }

    // A thread that creates packets from number 1 on, for a while, and until enough of them were taken.
    private Task Produce(Action<int, ReceivedPacket> publish) => Task.Factory.StartNew(
        () =>
        {
            var random = new Random(1);
            byte[] buffer = CheckedPacket.CreateBuffer();
            long start = Stopwatch.GetTimestamp();
            for (int number = 1; Stopwatch.GetElapsedTime(start) < TimeToRun(); number++)
            {
                publish(number, CheckedPacket.Write(buffer, number));
                Preemption.Stumble(random);
            }
        },
        CancellationToken.None,
        TaskCreationOptions.LongRunning,
        TaskScheduler.Default);

    private TimeSpan TimeToRun() => Volatile.Read(ref _taken) < LeastTaken ? Limits.Unexpected : LeastTime;

    // Takes until the producer has ended and nothing is left. take returns whether there was a packet.
    private static Task Consume(Task producer, Func<bool> take) => Task.Factory.StartNew(
        () =>
        {
            while (true)
            {
                bool ended = producer.IsCompleted;
                if (take())
                    continue;
                if (ended)
                    break;

                Thread.SpinWait(20);
            }

            producer.GetAwaiter().GetResult();
        },
        CancellationToken.None,
        TaskCreationOptions.LongRunning,
        TaskScheduler.Default).Soon();
}
