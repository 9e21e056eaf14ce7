using NeuronMocap.Delivery;
using NeuronMocap.Protocol;

namespace NeuronMocap.Tests.Delivery;

public sealed class LatestPacketTests
{
    [Fact]
    public void There_is_no_packet_at_first() => Assert.False(new LatestPacket(64).TryTake(out _));

    [Fact]
    public void Only_the_newest_packet_is_taken_once()
    {
        var newest = new LatestPacket(64);
        for (int i = 1; i <= 5; i++)
            newest.Publish(Packet(i));

        Assert.True(newest.TryTake(out ReceivedPacket packet));
        Assert.Equal(5, packet.Timestamp);
        Assert.False(newest.TryTake(out _));
        newest.Publish(Packet(6));
        Assert.True(newest.TryTake(out packet));
        Assert.Equal(6, packet.Timestamp);
    }

    [Fact]
    public void A_taken_packet_is_unchanged_by_newer_ones()
    {
        var newest = new LatestPacket(64);
        newest.Publish(Packet(1));
        Assert.True(newest.TryTake(out ReceivedPacket held));
        for (int i = 2; i < 10; i++)
            newest.Publish(Packet(i));

        Assert.Equal(-1, held.Bytes.IndexOfAnyExcept((byte)1));
    }

    [Fact]
    public async Task Packets_are_never_torn_or_older_under_two_threads()
    {
        const int Published = 300_000;
        var newest = new LatestPacket(256);
        Task producer = Task.Run(() =>
        {
            byte[] bytes = new byte[256];
            for (int i = 1; i <= Published; i++)
            {
                bytes.AsSpan().Fill((byte)i);
                newest.Publish(new ReceivedPacket(PacketKind.Motion, bytes, i, 0));
                if (i % 64 == 0)
                    Thread.Yield();
            }
        });

        long last = 0;
        while (true)
        {
            bool ended = producer.IsCompleted;
            if (!newest.TryTake(out ReceivedPacket packet))
            {
                if (ended)
                    break;

                Thread.Yield();
                continue;
            }

            Assert.True(packet.Timestamp > last, $"{packet.Timestamp} after {last}");
            Assert.Equal(-1, packet.Bytes.IndexOfAnyExcept((byte)packet.Timestamp));
            last = packet.Timestamp;
        }

        await producer.Soon();
        Assert.Equal(Published, last);
    }

    private static ReceivedPacket Packet(int number)
    {
        byte[] bytes = new byte[64];
        bytes.AsSpan().Fill((byte)number);
        return new ReceivedPacket(PacketKind.Motion, bytes, number, 0);
    }
}
