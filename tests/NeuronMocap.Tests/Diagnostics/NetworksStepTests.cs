using System.Net;
using NeuronMocap.Diagnostics;

namespace NeuronMocap.Tests.Diagnostics;

public sealed class NetworksStepTests
{
    private static readonly OwnNetwork[] Networks =
    [
        new("lo", IPAddress.Loopback, 8),
        new("wlan0", IPAddress.Parse("10.0.0.5"), 24),
        new("eth0", IPAddress.Parse("192.168.1.35"), 24),
        new("eth0", IPAddress.Parse("2001:db8:1::35"), 64),
        new("tun0", IPAddress.Parse("10.8.0.2"), 32, IsVpn: true),
        new("eth1", Address: null, 0, IsUp: false),
        new("usb0", Address: null, 0),
    ];

    [Theory]
    [InlineData("192.168.1.35", "192.168.1.20", "eth0 192.168.1.35/24 (used), wlan0 10.0.0.5/24, tun0 10.8.0.2/32 (VPN), eth0 2001:db8:1::35/64, eth1 is down, usb0 has no address")]
    [InlineData("2001:db8:1::35", "2001:db8:1::20", "eth0 2001:db8:1::35/64 (used), wlan0 10.0.0.5/24, eth0 192.168.1.35/24, tun0 10.8.0.2/32 (VPN), eth1 is down, usb0 has no address")]
    [InlineData(null, null, "wlan0 10.0.0.5/24, eth0 192.168.1.35/24, tun0 10.8.0.2/32 (VPN), eth0 2001:db8:1::35/64, eth1 is down, usb0 has no address")]
    public void The_used_network_comes_first_and_the_others_follow(string? used, string? remote, string expected) =>
        Assert.Equal((StepOutcome.Ok, expected), Describe(Networks, used, remote));

    [Theory]
    [InlineData("10.0.0.5", "192.168.1.20", "the server 192.168.1.20 is in the network of eth0, but the connection uses wlan0. Set LocalAddress to 192.168.1.35")]
    [InlineData("10.8.0.2", "2001:db8:1::20", "the server 2001:db8:1::20 is in the network of eth0, but the connection uses tun0. Set LocalAddress to 2001:db8:1::35")]
    [InlineData("10.8.0.2", "172.16.0.9", "the connection uses a VPN. If the server is not behind it, set LocalAddress to an address of the server's network")]
    public void A_doubtful_choice_of_the_network_is_a_warning(string used, string remote, string expected)
    {
        (StepOutcome outcome, string detail) = Describe(Networks, used, remote);
        Assert.Equal(StepOutcome.Warning, outcome);
        Assert.EndsWith(": " + expected, detail, StringComparison.Ordinal);
    }

    [Fact]
    public void A_server_behind_a_router_is_no_warning() => Assert.Equal(StepOutcome.Ok, Describe(Networks, "192.168.1.35", "172.16.0.9").Outcome);

    [Fact]
    public void Networks_that_are_all_down_are_a_warning() => Assert.Equal(
        (StepOutcome.Warning, "eth1 is down, usb0 has no address: no network of this computer is up"), Describe(Networks[^2..], used: null, "192.168.1.20"));

    [Fact]
    public void A_long_list_is_shortened_and_an_unknown_one_is_left_out()
    {
        OwnNetwork[] many = [.. Enumerable.Range(0, 11).Select(static i => new OwnNetwork($"veth{i}", new IPAddress([172, 17, (byte)i, 1]), 24))];
        (_, string detail) = Describe(many, "172.17.10.1", remote: null);
        Assert.StartsWith("veth10 172.17.10.1/24 (used), veth0", detail, StringComparison.Ordinal);
        Assert.EndsWith("veth6 172.17.6.1/24 and 3 more", detail, StringComparison.Ordinal);

        var log = new StepLog(progress: null);
        NetworksStep.Add(log, Networks[..1], used: null, remote: null);
        NetworksStep.Add(log, [], used: null, remote: null);
        Assert.Empty(log.Steps);
    }

    // As on a computer with containers: most networks are down, and they come first.
    [Fact]
    public void Networks_that_are_down_do_not_hide_the_others()
    {
        OwnNetwork[] many =
        [
            .. Enumerable.Range(0, 9).Select(static i => new OwnNetwork($"veth{i}", Address: null, 0, IsUp: false)),
            .. Enumerable.Range(0, 2).Select(static i => new OwnNetwork($"usb{i}", Address: null, 0)),
            .. Networks[1..4],
        ];
        Assert.Equal(
            (StepOutcome.Ok, "eth0 192.168.1.35/24 (used), wlan0 10.0.0.5/24, eth0 2001:db8:1::35/64, 9 are down, 2 have no address"),
            Describe(many, "192.168.1.35", remote: null));
        Assert.Equal(
            (StepOutcome.Warning, "9 are down, 2 have no address: no network of this computer is up"),
            Describe(many[..^3], used: null, remote: null));
    }

    [Theory]
    [InlineData("tun0", "", true)]
    [InlineData("utun4", "", true)]
    [InlineData("Ethernet 3", "TAP-Windows Adapter V9", true)]
    [InlineData("Local", "WireGuard Tunnel", true)]
    [InlineData("eth0", "Intel(R) Ethernet Connection", false)]
    [InlineData("WLAN", "Wireless adapter", false)]
    public void A_vpn_is_known_by_its_name(string name, string description, bool isVpn) => Assert.Equal(isVpn, OwnNetwork.IsVpnNamed(name, description));

    [Theory]
    [InlineData("192.168.1.35", 24, "192.168.1.250", true)]
    [InlineData("192.168.1.35", 24, "192.168.2.35", false)]
    [InlineData("192.168.1.35", 23, "192.168.0.35", true)]
    [InlineData("2001:db8::1", 64, "2001:db8::ffff", true)]
    [InlineData("2001:db8::1", 64, "2001:db8:0:1::1", false)]
    [InlineData("192.168.1.35", 24, "::ffff:192.168.1.35", false)]
    public void Addresses_of_both_families_are_compared_by_their_prefix(string own, int prefixLength, string other, bool isInside) =>
        Assert.Equal(isInside, new OwnNetwork("eth0", IPAddress.Parse(own), prefixLength).Contains(IPAddress.Parse(other)));

    // The address of a tunnel has no neighbours, and Mono may not know the length of a prefix.
    [Theory]
    [InlineData("192.168.1.35", 24, "192.168.1.20", "from 192.168.1.35 (eth0), on the same network")]
    [InlineData("192.168.1.35", 24, "192.168.2.20", "from 192.168.1.35 (eth0), through a router: not on the same network")]
    [InlineData("10.8.0.2", 32, "192.168.2.20", "from 10.8.0.2 (eth0)")]
    [InlineData("2001:db8::1", 128, "2001:db8::2", "from 2001:db8::1 (eth0)")]
    [InlineData("192.168.1.35", 0, "192.168.2.20", "from 192.168.1.35 (eth0)")]
    [InlineData("192.168.1.35", 24, "127.0.0.1", "from 192.168.1.35, inside this computer")]
    public void A_router_is_named_only_if_the_network_is_known(string local, int prefixLength, string remote, string expected)
    {
        IPAddress address = IPAddress.Parse(local);
        Assert.Equal(expected, LocalNetwork.DescribeRoute([new OwnNetwork("eth0", address, prefixLength)], address, IPAddress.Parse(remote)));
        Assert.StartsWith($"from {local}", LocalNetwork.DescribeRoute([], address, IPAddress.Parse(remote)), StringComparison.Ordinal);
    }

    [Fact]
    public void The_networks_of_this_computer_are_found() =>
        Assert.Contains(OwnNetwork.FindAll(), static network => network.IsLoopback && network.Contains(IPAddress.Parse("127.0.0.9")));

    private static (StepOutcome Outcome, string Detail) Describe(OwnNetwork[] networks, string? used, string? remote)
    {
        var log = new StepLog(progress: null);
        NetworksStep.Add(log, networks, used is null ? null : IPAddress.Parse(used), remote is null ? null : IPAddress.Parse(remote));
        DiagnosisStep step = Assert.Single(log.Steps);
        Assert.Equal("networks", step.Name);
        return (step.Outcome, step.Detail);
    }
}
