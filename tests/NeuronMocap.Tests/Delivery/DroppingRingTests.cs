using NeuronMocap.Delivery;
using NeuronMocap.Protocol;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Delivery;

public sealed class DroppingRingTests
{
    [Theory]
    [InlineData(1, 1)]
    [InlineData(3, 4)]
    [InlineData(512, 512)]
    public void Capacity_is_rounded_up_to_a_power_of_two(int asked, int given) => Assert.Equal(given, new DroppingRing(asked, 64).Capacity);

    [Theory]
    [InlineData(0)]
    [InlineData(int.MaxValue - 2)]
    [InlineData(-3)]
    public void Every_fill_and_overflow_keeps_exactly_the_newest(int firstIndex)
    {
        var ring = new DroppingRing(4, 64, firstIndex);
        int written = 0;
        for (int count = 0; count < 14; count++)
        {
            for (int i = 0; i < count; i++)
                ring.Store(Packet(written++));

            Assert.Equal(Math.Min(count, 4), ring.Count);
            for (int number = Math.Max(written - 4, written - count); number < written; number++)
                Assert.Equal(number, Take(ring));

            Assert.False(ring.TryTake(out _));
            Assert.Equal((written, 0), (ring.Taken + ring.Dropped, ring.Count));
        }
    }

    [Fact]
    public void A_packet_in_use_stays_while_the_ring_turns()
    {
        var ring = new DroppingRing(2, 64);
        ring.Store(Packet(1));
        ring.Store(Packet(2));
        Assert.True(ring.TryTake(out ReceivedPacket held));
        for (int number = 3; number < 20; number++)
        {
            ring.Store(Packet(number));
            Assert.Equal(1, Number(held));
            Assert.Equal(2, ring.Count);
        }

        Assert.Equal((18, 19), (Take(ring), Take(ring)));
        Assert.Equal((16, 3), (ring.Dropped, ring.Taken));
    }

    [Fact]
    public void A_slot_grows_to_a_larger_packet_and_keeps_its_fields()
    {
        var ring = new DroppingRing(1, slotSize: 8);
        byte[] large = TestPackets.Calculation(frame: 3);
        ring.Store(new ReceivedPacket(PacketKind.Calculation, large, timestamp: 42, origin: 7));

        Assert.True(ring.TryTake(out ReceivedPacket packet));
        Assert.Equal(large, packet.Bytes.ToArray());
        Assert.Equal((PacketKind.Calculation, 42L, 7), (packet.Kind, packet.Timestamp, packet.Sender));
    }

    [Fact]
    public async Task A_third_thread_never_sees_an_impossible_count()
    {
        var ring = new DroppingRing(8, 64);
        using var stop = new CancellationTokenSource();
        Task moving = Task.Run(() =>
        {
            for (int i = 0; !stop.IsCancellationRequested; i++)
            {
                ring.Store(Packet(i));
                if (i % 3 == 0)
                    ring.TryTake(out _);
            }
        });
        for (int i = 0; i < 200_000; i++)
            Assert.InRange(ring.Count, 0, 8);

        await stop.CancelAsync();
        await moving.Soon();
    }

    private static int Take(DroppingRing ring)
    {
        Assert.True(ring.TryTake(out ReceivedPacket packet));
        return Number(packet);
    }

    private static ReceivedPacket Packet(int number) => new(PacketKind.Motion, BitConverter.GetBytes(number), number, 0);

    private static int Number(in ReceivedPacket packet) => BitConverter.ToInt32(packet.Bytes);
}
