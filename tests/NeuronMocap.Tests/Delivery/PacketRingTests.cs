using NeuronMocap.Delivery;
using NeuronMocap.Protocol;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Delivery;

public sealed class PacketRingTests
{
    [Theory]
    [InlineData(1, 1)]
    [InlineData(2, 2)]
    [InlineData(3, 4)]
    [InlineData(512, 512)]
    [InlineData(513, 1024)]
    public void Capacity_is_rounded_up_to_a_power_of_two(int asked, int given) => Assert.Equal(given, new PacketRing(asked, 64).Capacity);

    [Theory]
    [InlineData(0)]
    [InlineData(int.MaxValue - 2)]
    [InlineData(-3)]
    public void Packets_stay_in_order_when_indices_wrap(int firstIndex)
    {
        var ring = new PacketRing(4, 64, firstIndex);
        int written = 0;
        int read = 0;
        for (int lap = 0; lap < 100; lap++)
        {
            for (int i = 0; i < 1 + (lap % 4); i++)
                Assert.True(ring.TryEnqueue(Packet(written++)));

            Assert.Equal(written - read, ring.Count);
            while (ring.TryPeek(out ReceivedPacket packet))
            {
                Assert.Equal(read++, Number(packet));
                ring.Release();
            }
        }

        Assert.Equal(written, read);
        Assert.Equal(0, ring.Count);
    }

    [Fact]
    public void A_full_ring_refuses_the_newest()
    {
        var ring = new PacketRing(2, 64);
        Assert.True(ring.TryEnqueue(Packet(1)));
        Assert.True(ring.TryEnqueue(Packet(2)));
        Assert.False(ring.TryEnqueue(Packet(3)));

        Assert.True(ring.TryPeek(out ReceivedPacket first));
        Assert.Equal(1, Number(first));
        Assert.False(ring.TryEnqueue(Packet(4)));
        ring.Release();
        Assert.True(ring.TryEnqueue(Packet(5)));

        Assert.True(ring.TryPeek(out ReceivedPacket second));
        Assert.Equal(2, Number(second));
        ring.Release();
        Assert.True(ring.TryPeek(out ReceivedPacket third));
        Assert.Equal(5, Number(third));
    }

    [Fact]
    public void A_slot_grows_to_a_larger_packet_and_keeps_its_fields()
    {
        var ring = new PacketRing(1, slotSize: 8);
        byte[] large = TestPackets.Calculation(frame: 3);
        Assert.True(ring.TryEnqueue(new ReceivedPacket(PacketKind.Calculation, large, timestamp: 42, origin: 7)));

        Assert.True(ring.TryPeek(out ReceivedPacket packet));
        Assert.Equal(large, packet.Bytes.ToArray());
        Assert.Equal((PacketKind.Calculation, 42L, 7), (packet.Kind, packet.Timestamp, packet.Sender));
    }

    [Fact]
    public async Task Two_threads_keep_the_order_and_lose_only_refused_packets()
    {
        const int Sent = 300_000;
        var ring = new PacketRing(8, 64, int.MaxValue - 1000);
        int refused = 0;
        Task producer = Task.Run(() =>
        {
            byte[] bytes = new byte[64];
            for (int i = 0; i < Sent; i++)
            {
                bytes.AsSpan().Fill((byte)i);
                BitConverter.TryWriteBytes(bytes, i);
                if (!ring.TryEnqueue(new ReceivedPacket(PacketKind.Motion, bytes, i, 0)))
                    refused++;
                if (i % 64 == 0)
                    Thread.Yield();
            }
        });

        int received = 0;
        int last = -1;
        while (true)
        {
            bool ended = producer.IsCompleted;
            if (!ring.TryPeek(out ReceivedPacket packet))
            {
                if (ended)
                    break;

                Thread.Yield();
                continue;
            }

            int number = Number(packet);
            Assert.True(number > last, $"{number} after {last}");
            Assert.Equal(-1, packet.Bytes[4..].IndexOfAnyExcept((byte)number));
            last = number;
            received++;
            ring.Release();
        }

        await producer.Soon();
        Assert.Equal(Sent, received + refused);
        Assert.True(received >= 8);
    }

    [Fact]
    public async Task A_third_thread_never_sees_an_impossible_count()
    {
        var ring = new PacketRing(8, 64);
        using var stop = new CancellationTokenSource();
        Task moving = Task.Run(() =>
        {
            for (int i = 0; !stop.IsCancellationRequested; i++)
            {
                ring.TryEnqueue(Packet(i));
                if (ring.TryPeek(out _))
                    ring.Release();
            }
        });
        for (int i = 0; i < 200_000; i++)
            Assert.InRange(ring.Count, 0, 8);

        await stop.CancelAsync();
        await moving.Soon();
    }

    private static ReceivedPacket Packet(int number) => new(PacketKind.Motion, BitConverter.GetBytes(number), number, 0);

    private static int Number(in ReceivedPacket packet) => BitConverter.ToInt32(packet.Bytes);
}
