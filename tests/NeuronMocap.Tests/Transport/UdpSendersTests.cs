using System.Diagnostics;
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
        Assert.Equal([1, 0], _log.Packets.Select(packet => packet.Sender));
    }

    [Fact]
    public void A_lost_second_half_loses_one_frame()
    {
        byte[] second = TestPackets.Motion(2);
        Push(5000, TestPackets.Motion(1)[..1024]);
        Push(5000, second[..1024]);
        Push(5000, second[1024..]);
        Assert.Equal(second, Assert.Single(_log.Packets).Bytes);
        Assert.Equal(1024, _log.Skipped);
    }

    [Fact]
    public void A_lost_first_half_loses_one_frame()
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
    public void A_flood_of_forged_headers_does_not_evict_a_real_sender()
    {
        byte[] frame = TestPackets.Motion(1);
        for (int forged = 1; forged <= 20_000; forged++)
        {
            PushFrom(Host(forged), 5000, frame[..1024]);
            if (forged % 50 != 0)
                continue;

            Push(60_000, frame[..1024]);
            Push(60_000, frame[1024..]);
        }

        Assert.Equal((64, 64), (UdpSenders.Limit, _senders.Count));
        Assert.Equal(400, _log.Packets.Count);
        Assert.Equal([0], _log.Packets.Select(packet => packet.Sender - _log.Packets[0].Sender).Distinct());
        Assert.InRange(_log.Skipped, 1024 * (20_000 - 64), 1024 * 20_000);
    }

    [Fact]
    public void A_flood_of_forged_frames_does_not_evict_an_active_sender()
    {
        byte[] frame = TestPackets.Motion(1);
        for (int forged = 1; forged <= 20_000; forged++)
        {
            PushFrom(Host(forged), 5000, frame);
            if (forged % 50 == 0)
                Push(60_000, frame);
            if (forged == 1)
                Push(60_000, frame);
        }

        Assert.Equal(64, _senders.Count);
        Assert.Equal(401, _log.Packets.Count(packet => packet.Sender == 1));
        Assert.Equal(63, _log.Packets.Count(packet => packet.Sender != 1));
        Assert.Equal([SkipReason.TooManySenders], _log.Reasons.Distinct());
    }

    [Fact]
    public void Senders_without_a_frame_for_five_seconds_make_room()
    {
        byte[] frame = TestPackets.Motion(1);
        for (int sender = 1; sender <= 64; sender++)
            PushFrom(Host(sender), 5000, frame, seconds: 1);

        PushFrom(Host(100), 5000, frame, seconds: 5.9);
        Assert.Equal(64, _log.Packets.Count);
        PushFrom(Host(100), 5000, frame, seconds: 6.1);
        Assert.Equal(65, _log.Packets.Count);
    }

    [Fact]
    public void Bytes_without_a_header_create_no_sender()
    {
        PushFrom(Host(1), 5000, new byte[500]);
        PushFrom(Host(2), 5000, TestPackets.Motion(1)[1024..]);
        PushFrom(Host(3), 5000, TestPackets.Motion(1)[..63]);
        Assert.Equal((0, 500 + 456 + 63), (_senders.Count, _log.Skipped));
    }

    [Fact]
    public void A_new_port_continues_a_silent_one_of_its_address()
    {
        Push(5000, TestPackets.Motion(1), seconds: 0);
        Push(5001, TestPackets.Motion(2), seconds: 10);
        Assert.True(_senders.IsWaiting);
        Push(5001, TestPackets.Motion(3), seconds: 10.06);
        Assert.Equal([0, 0, 0], Sources());
        Assert.True(_log.Origins[1] != _log.Origins[0]);
    }

    // The receive loop stands still, and reads the datagrams of that time one after the other. The second server sent its first one just after the first
    // server's last one that was read.
    [Fact]
    public void A_server_that_begins_while_a_handler_runs_is_a_second_server()
    {
        Push(5000, TestPackets.Motion(1), seconds: 0);
        Push(5001, TestPackets.Motion(2), seconds: 0.4);
        Push(5000, TestPackets.Motion(3), seconds: 0.4001);
        Push(5001, TestPackets.Motion(4), seconds: 0.4002);
        _senders.Settle(Ticks(0.5));
        Assert.Equal([0, 1, 0, 1], Sources());
    }

    [Fact]
    public void A_new_port_waits_for_the_silence_of_the_old_without_loss()
    {
        for (int i = 0; i < 10; i++)
            Push(5000, TestPackets.Motion(i), seconds: i * 0.016);
        for (int i = 10; i < 100; i++)
            Push(5001, TestPackets.Motion(i), seconds: i * 0.016);

        Assert.Equal(Enumerable.Range(0, 100).Select(i => TestPackets.Motion(i)), _log.Packets.Select(packet => packet.Bytes));
        Assert.Equal([0], Sources().Distinct());
    }

    [Fact]
    public void Waiting_frames_are_delivered_without_another_datagram()
    {
        Push(5000, TestPackets.Motion(1), seconds: 0);
        Push(5001, TestPackets.Motion(2), seconds: 0.01);
        Assert.True(_senders.IsWaiting);
        _senders.Settle(Ticks(0.2));
        Assert.True(_senders.IsWaiting);
        _senders.Settle(Ticks(0.3));
        Assert.False(_senders.IsWaiting);
        Assert.Equal([0, 0], Sources());
    }

    [Fact]
    public void Two_active_ports_of_an_address_are_two_sources()
    {
        for (int i = 0; i < 100; i++)
        {
            Push(5000, TestPackets.Motion(i), seconds: i * 0.016);
            Push(5001, TestPackets.Motion(1000 + i), seconds: (i * 0.016) + 0.004);
        }

        _senders.Settle(Ticks(100));
        Assert.Equal(Enumerable.Range(0, 100).SelectMany(i => new[] { TestPackets.Motion(i), TestPackets.Motion(1000 + i) }), _log.Packets.Select(packet => packet.Bytes));
        Assert.Equal(Enumerable.Range(0, 100).SelectMany(_ => new[] { 0, 1 }), Sources());
    }

    [Fact]
    public void A_slow_active_server_keeps_its_source()
    {
        for (int i = 0; i < 5; i++)
            Push(5000, TestPackets.Motion(i), seconds: i * 0.2);
        for (int i = 0; i < 20; i++)
        {
            Push(5001, TestPackets.Motion(100 + i), seconds: 0.81 + (i * 0.05));
            if (i % 4 == 3)
                Push(5000, TestPackets.Motion(5 + i), seconds: 0.81 + (i * 0.05));
        }

        Assert.Equal([1], _log.Packets.Where(packet => packet.Sender != 0).Select(packet => packet.Sender).Distinct());
        Assert.Equal((10, 20), (Sources().Count(source => source == 0), Sources().Count(source => source == 1)));
    }

    [Fact]
    public void A_replaced_port_that_sends_again_is_a_second_server()
    {
        Push(5000, TestPackets.Motion(1), seconds: 0);
        Push(5001, TestPackets.Motion(2), seconds: 10);
        _senders.Settle(Ticks(10.06));
        for (int i = 0; i < 10; i++)
        {
            Push(5000, TestPackets.Motion(3), seconds: 10.07 + (i * 0.02));
            Push(5001, TestPackets.Motion(4), seconds: 10.08 + (i * 0.02));
        }

        Assert.Equal((12, 10), (Sources().Count(source => source == 0), Sources().Count(source => source == 1)));
        Assert.Equal([TestPackets.Motion(3)], _log.Packets.Where(packet => packet.Sender == 1).Select(packet => packet.Bytes).DistinctBy(Convert.ToHexString));
    }

    [Fact]
    public void A_new_port_continues_the_silent_one_of_two_servers()
    {
        for (int i = 0; i < 50; i++)
        {
            Push(5000, TestPackets.Motion(i, avatar: 1), seconds: i * 0.016);
            if (i < 20)
                Push(5001, TestPackets.Motion(i, avatar: 2), seconds: (i * 0.016) + 0.001);
            if (i >= 21)
                Push(5002, TestPackets.Motion(i, avatar: 2), seconds: (i * 0.016) + 0.001);
        }

        _senders.Settle(Ticks(0.9));
        Assert.Equal((50, 49), (Sources().Count(source => source == 0), Sources().Count(source => source == 1)));
    }

    [Fact]
    public void Calculation_from_another_port_joins_the_motion_at_once()
    {
        Push(5000, TestPackets.Motion(1), seconds: 0);
        Push(5001, TestPackets.Calculation(1), seconds: 0.001);
        Push(5000, TestPackets.Motion(2), seconds: 0.016);
        Push(5001, TestPackets.Calculation(2), seconds: 0.017);
        Assert.Equal([0, 0, 0, 0], Sources());
    }

    [Fact]
    public void A_second_server_that_begins_with_calculation_stays_separate()
    {
        Push(5000, TestPackets.Motion(1), seconds: 0);
        Push(5001, TestPackets.Calculation(7), seconds: 0.001);
        Push(5001, TestPackets.Motion(7), seconds: 0.002);
        Push(5000, TestPackets.Motion(2), seconds: 0.016);
        Push(5001, TestPackets.Calculation(8), seconds: 0.017);
        Assert.Equal([0, 0, 1, 0, 1], Sources());
    }

    [Fact]
    public void A_flood_of_ports_of_its_address_does_not_displace_a_server()
    {
        for (int i = 0; i < 600; i++)
        {
            Push(5000, TestPackets.Motion(i), seconds: i * 0.016);
            for (int forged = 0; forged < 4; forged++)
                Push(10_000 + (i * 4) + forged, TestPackets.Motion(9), seconds: (i * 0.016) + 0.002);
        }

        Same.Packets(
            Enumerable.Range(0, 600).Select(i => TestPackets.Motion(i)),
            _log.Packets.Where(packet => packet.Sender == 0).Select(packet => packet.Bytes));
        Assert.InRange(_senders.Count, 1, 64);
    }

    // A datagram that makes room for another port of its own address must not lose its own place.
    [Fact]
    public void A_sender_is_not_evicted_by_its_own_datagram()
    {
        byte[] frame = TestPackets.Motion(1);
        for (int host = 1; host <= UdpSenders.Limit - 1; host++)
            PushFrom(Host(host), 5000, frame);

        Push(5000, frame[..1024]);
        Push(5001, frame, seconds: 0.01);
        Push(5000, frame, seconds: 0.02);

        Assert.Equal(UdpSenders.Limit, _senders.Count);
        Assert.Equal(UdpSenders.Limit, _log.Packets.Count);
        Assert.Equal(1024 + frame.Length, _log.Skipped);
        Assert.Equal(SkipReason.TooManySenders, _log.Reasons[0]);
    }

    [Fact]
    public void The_callers_address_is_copied()
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

    private void Push(int port, byte[] datagram, double seconds = 0) => PushFrom(IPAddress.Loopback, port, datagram, seconds);

    private void PushFrom(IPAddress address, int port, byte[] datagram, double seconds = 0) =>
        _senders.Push(new IPEndPoint(address, port).Serialize(), datagram, Ticks(seconds));

    private IEnumerable<int> Sources() => _log.Packets.Select(packet => packet.Sender);

    private static long Ticks(double seconds) => (long)(seconds * Stopwatch.Frequency);

    private static IPAddress Host(int number) => new([10, 0, (byte)(number >> 8), (byte)number]);

    private static SocketAddress Address(int port) => new IPEndPoint(IPAddress.Loopback, port).Serialize();
}
