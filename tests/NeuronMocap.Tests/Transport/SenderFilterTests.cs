using System.Net;
using NeuronMocap.Protocol;
using NeuronMocap.Tests.Network;
using NeuronMocap.Transport;

namespace NeuronMocap.Tests.Transport;

public sealed class SenderFilterTests
{
    [Theory]
    [InlineData("192.168.1.20", true)]
    [InlineData("192.168.1.21", false)]
    [InlineData("192.168.20.1", false)]
    [InlineData("fe80::20", true)]
    [InlineData("fe80::21", false)]
    [InlineData("10.0.0.7", true)]
    [InlineData("::ffff:192.168.1.20", false)]
    public void Listed_addresses_may_send_from_any_port(string sender, bool expected)
    {
        var filter = new SenderFilter([IPAddress.Parse("192.168.1.20"), IPAddress.Parse("fe80::20"), IPAddress.Parse("::ffff:10.0.0.7")]);
        Assert.Equal(expected, filter.Allows(Address(sender, 1)));
        Assert.Equal(expected, filter.Allows(Address(sender, 65_535)));
    }

    [Fact]
    public void An_empty_list_lets_everyone_send() => Assert.True(new SenderFilter([]).Allows(Address("192.168.1.20", 7002)));

    [Fact]
    public void Blocked_senders_are_counted_and_four_are_remembered()
    {
        var filter = new SenderFilter([IPAddress.Parse("10.0.0.1")]);
        for (int i = 0; i < 20_000; i++)
            filter.CountRefused(Address($"127.0.{i / 200}.{i % 200}", i));

        Assert.Equal(20_000, filter.RefusedDatagrams);
        Assert.Equal(["127.0.0.0", "127.0.0.1", "127.0.0.2", "127.0.0.3"], filter.RefusedSenders.Select(address => address.ToString()));
    }

    [Fact]
    public void A_blocked_datagram_is_not_parsed()
    {
        var filter = new SenderFilter([IPAddress.Parse("10.0.0.1")]);
        var log = new PacketLog();
        var senders = new UdpSenders(new PacketScanner(), log, filter);
        SocketAddress[] addresses = [.. Enumerable.Range(1, 50).Select(i => Address($"127.0.0.{i}", i))];
        byte[] frame = TestPackets.Motion(1);
        int pushed = 0;
        Allocations.AssertNone(() =>
        {
            foreach (SocketAddress address in addresses)
                senders.Push(address, frame, 0);

            pushed += addresses.Length;
        });

        Assert.Equal((0, 0, 0), (log.Packets.Count, log.Skipped, senders.Count));
        Assert.Equal(pushed, filter.RefusedDatagrams);
    }

    private static SocketAddress Address(string address, int port) => new IPEndPoint(IPAddress.Parse(address), port).Serialize();
}
