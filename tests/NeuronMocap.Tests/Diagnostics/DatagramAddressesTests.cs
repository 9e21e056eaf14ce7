using System.Net;
using System.Net.Sockets;
using NeuronMocap.Diagnostics;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Diagnostics;

public sealed class DatagramAddressesTests
{
    private static readonly IPAddress[] Addresses = [IPAddress.Parse("10.0.0.5"), IPAddress.Parse("192.168.1.35")];

    [Theory]
    [InlineData(null, "other computers send to 10.0.0.5 or 192.168.1.35, programs on this one to 127.0.0.1", "10.0.0.5:7012", "127.0.0.1:7012")]
    [InlineData("0.0.0.0", "other computers send to 10.0.0.5 or 192.168.1.35, programs on this one to 127.0.0.1", "10.0.0.5:7012", "127.0.0.1:7012")]
    [InlineData("192.168.1.35", "other computers and programs on this one send to 192.168.1.35", "192.168.1.35:7012", "192.168.1.35:7012")]
    [InlineData("2001:db8::1", "other computers and programs on this one send to 2001:db8::1", "[2001:db8::1]:7012", "[2001:db8::1]:7012")]
    [InlineData("127.0.0.1", "only programs on this computer can send here, to 127.0.0.1", "127.0.0.1:7012", "127.0.0.1:7012")]
    public void The_addresses_that_receive_are_named(string? bound, string route, string fromNetwork, string own)
    {
        var addresses = new DatagramAddresses(bound is null ? null : IPAddress.Parse(bound), Addresses);
        Assert.Equal((route, fromNetwork), (addresses.Route, addresses.FromNetwork(7012)));
        Assert.StartsWith($"A server on this computer sends to {own}.", addresses.Advice(7012), StringComparison.Ordinal);
    }

    [Fact]
    public void Without_a_network_only_this_computer_is_named()
    {
        var addresses = new DatagramAddresses(bound: null, []);
        Assert.Equal(
            ("this computer has no network: only programs on it can send here, to 127.0.0.1", "127.0.0.1:7012"),
            (addresses.Route, addresses.FromNetwork(7012)));
    }

    [Fact]
    public void A_local_address_that_receives_no_broadcasts_is_named()
    {
        Assert.DoesNotContain("broadcast", new DatagramAddresses(bound: null, Addresses).Advice(7012), StringComparison.Ordinal);
        Assert.DoesNotContain("broadcast", new DatagramAddresses(IPAddress.Loopback, Addresses).Advice(7012), StringComparison.Ordinal);
        Assert.DoesNotContain("leave out LocalAddress", new DatagramAddresses(IPAddress.Parse("192.168.1.255"), Addresses).Advice(7012), StringComparison.Ordinal);
        Assert.Contains("choose another LocalAddress", new DatagramAddresses(IPAddress.Loopback, Addresses).Advice(7012), StringComparison.Ordinal);
        Assert.Equal(
            !OperatingSystem.IsWindows(),
            new DatagramAddresses(Addresses[1], Addresses).Advice(7012).Contains("leave out LocalAddress", StringComparison.Ordinal));
    }

    // What docs/guide/network.md says of broadcasts and LocalAddress.
    [Theory]
    [InlineData(null, true)]
    [InlineData("127.0.0.1", false)]
    [InlineData("127.255.255.255", true)]
    public async Task Linux_delivers_broadcasts_to_no_other_local_address(string? local, bool arrives)
    {
        Assert.SkipUnless(OperatingSystem.IsLinux(), "Only Linux delivers broadcasts on its loopback network.");
        var options = new NeuronReaderOptions { Transport = TransportKind.Udp, Port = 0, LocalAddress = local is null ? null : IPAddress.Parse(local) };
        await using var reader = new NeuronReader(options);
        await reader.StartAsync(TestContext.Current.CancellationToken);
        int port = ((IPEndPoint)reader.Status.LocalEndPoint!).Port;
        using var sender = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp) { EnableBroadcast = true };
        sender.SendTo(TestPackets.Motion(1), new IPEndPoint(IPAddress.Parse("127.255.255.255"), port));

        // Linux keeps the order on this network, so the second frame shows that the first one was dropped.
        sender.SendTo(TestPackets.Motion(2), new IPEndPoint(local == "127.255.255.255" ? IPAddress.Parse(local) : IPAddress.Loopback, port));
        await reader.WaitForFramesAsync(arrives ? 2 : 1);
        Assert.Equal(arrives ? 2 : 1, reader.GetStatistics().MotionFrames);
    }
}
