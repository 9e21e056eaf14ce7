using System.Net;
using NeuronMocap.Protocol;
using NeuronMocap.Tests.Network;
using NeuronMocap.Transport;

namespace NeuronMocap.Tests.Transport;

public sealed class UdpSendersTests
{
    private readonly PacketLog _log = new();
    private readonly UdpSenders _senders;

    public UdpSendersTests() => _senders = new UdpSenders(new PacketScanner(), _log, new SenderFilter([]));

    [Fact]
    public void A_frame_in_two_datagrams_is_joined()
    {
        byte[] frame = TestPackets.Motion(1);
        Push(5000, frame[..1024]);
        Push(5000, frame[1024..]);
        Assert.Equal(frame, Assert.Single(_log.Packets).Bytes);
        Assert.Equal(0, _log.Skipped);
    }

    [Fact]
    public void Halves_of_two_senders_are_not_mixed()
    {
        byte[] first = TestPackets.Motion(1);
        byte[] second = TestPackets.Motion(2);
        Push(5000, first[..1024]);
        Push(5001, second[..1024]);
        Push(5001, second[1024..]);
        Push(5000, first[1024..]);
        Assert.Equal([second, first], _log.Packets.Select(packet => packet.Bytes));
        Assert.Equal([1, 0], _log.Packets.Select(packet => packet.Source));
    }

    [Fact]
    public void A_lost_second_half_costs_one_frame_and_never_makes_one_of_two()
    {
        byte[] second = TestPackets.Motion(2);
        Push(5000, TestPackets.Motion(1)[..1024]);
        Push(5000, second[..1024]);
        Push(5000, second[1024..]);
        Assert.Equal(second, Assert.Single(_log.Packets).Bytes);
        Assert.Equal(1024, _log.Skipped);
    }

    [Fact]
    public void A_lost_first_half_costs_one_frame()
    {
        byte[] second = TestPackets.Motion(2);
        Push(5000, TestPackets.Motion(1)[1024..]);
        Push(5000, second[..1024]);
        Push(5000, second[1024..]);
        Assert.Equal(second, Assert.Single(_log.Packets).Bytes);
        Assert.Equal(456, _log.Skipped);
    }

    [Fact]
    public void Several_packets_in_one_datagram_are_all_delivered()
    {
        Push(5000, TestPackets.Motions(first: 0, count: 10));
        Assert.Equal(10, _log.Packets.Count);
    }

    [Fact]
    public void A_flood_of_forged_senders_keeps_the_newest_and_a_real_sender()
    {
        byte[] frame = TestPackets.Motion(1);
        for (int port = 1; port <= 20_000; port++)
        {
            Push(port, frame[..1024]);
            if (port % 50 != 0)
                continue;

            Push(60_000, frame[..1024]);
            Push(60_000, frame[1024..]);
        }

        Assert.Equal((64, 64), (UdpSenders.Limit, _senders.Count));
        Assert.Equal(400, _log.Packets.Count);
        Assert.InRange(_log.Skipped, 1024 * (20_000 - 64), 1024 * 20_000);
    }

    [Fact]
    public void The_callers_address_object_may_change_afterwards()
    {
        SocketAddress address = Address(5000);
        byte[] frame = TestPackets.Motion(1);
        _senders.Push(address, frame[..1024], 0);
        SocketAddress other = Address(5001);
        for (int i = 0; i < address.Size; i++)
            address[i] = other[i];

        _senders.Push(address, frame[1024..], 0);
        Assert.Empty(_log.Packets);
        _senders.Push(Address(5000), frame[1024..], 0);
        Assert.Single(_log.Packets);
    }

    private void Push(int port, byte[] datagram) => _senders.Push(Address(port), datagram, 0);

    private static SocketAddress Address(int port) => new IPEndPoint(IPAddress.Loopback, port).Serialize();
}
