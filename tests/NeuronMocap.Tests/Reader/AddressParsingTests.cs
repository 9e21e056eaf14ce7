using System.Net;
using NeuronMocap.Commands;

namespace NeuronMocap.Tests.Reader;

public sealed class AddressParsingTests
{
    [Theory]
    [InlineData("192.168.1.20", "192.168.1.20", 7001)]
    [InlineData(" studio:8012 ", "studio", 8012)]
    [InlineData("tcp://studio", "studio", 7001)]
    [InlineData("TCP://studio:7005/", "studio", 7005)]
    [InlineData("::1", "::1", 7001)]
    [InlineData("[::1]", "::1", 7001)]
    [InlineData("[fe80::1%2]:65535", "fe80::1%2", 65535)]
    public void An_address_of_a_server_gives_host_and_port(string address, string host, int port)
    {
        var options = NeuronReaderOptions.Parse(address);
        Assert.Equal((TransportKind.Tcp, host, port), (options.Transport, options.Host, options.Port));
        Assert.Null(options.LocalAddress);
    }

    [Theory]
    [InlineData("udp://:7002", 7002, null)]
    [InlineData("UDP://:0/", 0, null)]
    [InlineData("udp://192.168.1.35:7002", 7002, "192.168.1.35")]
    [InlineData("udp://[::1]:7002", 7002, "::1")]
    public void A_udp_address_gives_the_port_and_the_local_address(string address, int port, string? localAddress)
    {
        var options = NeuronReaderOptions.Parse(address);
        Assert.Equal((TransportKind.Udp, port), (options.Transport, options.Port));
        Assert.Equal(localAddress is null ? null : IPAddress.Parse(localAddress), options.LocalAddress);
    }

    [Theory]
    [InlineData("", "'' is not an address.")]
    [InlineData(":7001", "':7001' is not an address.")]
    [InlineData("a b", "'a b' is not an address.")]
    [InlineData("http://studio", "'http://studio' is not an address.")]
    [InlineData("[::1", "'[::1' is not an address.")]
    [InlineData("[::1]7001", "'[::1]7001' is not an address.")]
    [InlineData("a:b:c", "'a:b:c' is not an IPv6 address.")]
    [InlineData("studio:", "'' in 'studio:' is not a port. A port is a number from 1 to 65535.")]
    [InlineData("studio:0", "'0' in 'studio:0' is not a port.")]
    [InlineData("studio:65536", "'65536' in 'studio:65536' is not a port.")]
    [InlineData("studio:+1", "'+1' in 'studio:+1' is not a port.")]
    [InlineData("udp://7002", "'udp://7002' has no port.")]
    [InlineData("udp://studio:7002", "'studio' is not an address of this computer.")]
    [InlineData("udp://:65536", "'65536' in 'udp://:65536' is not a port. A port is a number from 0 to 65535.")]
    public void An_invalid_address_is_refused_with_a_reason(string address, string expected)
    {
        string message = Assert.Throws<FormatException>(() => NeuronReaderOptions.Parse(address)).Message;
        Assert.StartsWith(expected, message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("studio", "studio", 8013)]
    [InlineData("[::1]:8014", "::1", 8014)]
    public void A_command_address_has_its_own_default_port(string address, string host, int port)
    {
        var options = NeuronCommandOptions.Parse(address);
        Assert.Equal((host, port), (options.Host, options.Port));
        Assert.StartsWith("'udp://:1' is not", Assert.Throws<FormatException>(() => NeuronCommandOptions.Parse("udp://:1")).Message, StringComparison.Ordinal);
    }
}
