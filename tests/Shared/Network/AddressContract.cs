using System.Net;

namespace NeuronMocap.Tests.Network;

/// <summary>The ways in which users write addresses, for all code that reads them.</summary>
public abstract class AddressContract
{
    [Theory]
    [InlineData("studio", "studio", 7001)]
    [InlineData("studio/", "studio", 7001)]
    [InlineData("studio:8012", "studio", 8012)]
    [InlineData("studio.example:65535", "studio.example", 65535)]
    [InlineData(" studio:1\t", "studio", 1)]
    [InlineData("bühne-1:7003", "bühne-1", 7003)]
    [InlineData("192.168.1.20", "192.168.1.20", 7001)]
    [InlineData("192.168.1.20:7003", "192.168.1.20", 7003)]
    [InlineData("tcp://studio", "studio", 7001)]
    [InlineData("TCP://studio:7005/", "studio", 7005)]
    [InlineData("tcp://demo", "demo", 7001)]
    [InlineData("tcp://take.nmrec", "take.nmrec", 7001)]
    [InlineData("Tcp://[::1]:7003", "::1", 7003)]
    [InlineData("::1", "::1", 7001)]
    [InlineData("[::1]", "::1", 7001)]
    [InlineData("[::1]:7003", "::1", 7003)]
    [InlineData("fe80::1%2", "fe80::1%2", 7001)]
    [InlineData("[fe80::1%2]:65535", "fe80::1%2", 65535)]
    public void A_server_is_read(string address, string host, int port) =>
        Assert.Equal(new Address(TransportKind.Tcp, host, port, LocalAddress: null), Parse(address));

    [Theory]
    [InlineData("udp://:7002", 7002, null)]
    [InlineData(" UDP://:7002/ ", 7002, null)]
    [InlineData("udp://192.168.1.35:1", 1, "192.168.1.35")]
    [InlineData("udp://[::1]:65535", 65535, "::1")]
    [InlineData("udp://[fe80::1%2]:7002", 7002, "fe80::1%2")]
    public void A_port_of_this_computer_is_read(string address, int port, string? localAddress)
    {
        Address read = Parse(address);
        Assert.Equal((TransportKind.Udp, port), (read.Transport, read.Port));
        Assert.Equal(localAddress is null ? null : IPAddress.Parse(localAddress), read.LocalAddress);
    }

    [Theory]
    [InlineData(":7001", "':7001' is not an address. Use HOST or HOST:PORT, and [ADDRESS]:PORT for IPv6.")]
    [InlineData("tcp://", "'tcp://' is not an address.")]
    [InlineData("tcp://:7001", "'tcp://:7001' is not an address.")]
    [InlineData("tcp://studio/take", "'tcp://studio/take' is not an address.")]
    [InlineData("tcp://udp://:7001", "'tcp://udp://:7001' is not an address.")]
    [InlineData("two words", "'two words' is not an address.")]
    [InlineData("two\u00a0words", "'two\u00a0words' is not an address.")]
    [InlineData("bell\u0007", "'bell\u0007' is not an address.")]
    [InlineData("[::1", "'[::1' is not an address.")]
    [InlineData("[::1]7001", "'[::1]7001' is not an address.")]
    [InlineData("[studio:1]", "'studio:1' is not an IPv6 address.")]
    [InlineData("a:b:c", "'a:b:c' is not an IPv6 address.")]
    [InlineData("[::1]:", "'[::1]:' has no number after the colon.")]
    [InlineData("studio:", "'studio:' has no number after the colon. A port is a number from 1 to 65535.")]
    [InlineData("studio:0", "'0' in 'studio:0' is not a port. A port is a number from 1 to 65535.")]
    [InlineData("studio:65536", "'65536' in 'studio:65536' is not a port.")]
    [InlineData("studio:-1", "'-1' in 'studio:-1' is not a port.")]
    [InlineData("studio:+1", "'+1' in 'studio:+1' is not a port.")]
    [InlineData("studio: 1", "' 1' in 'studio: 1' is not a port.")]
    [InlineData("studio:７００１", "'７００１' in 'studio:７００１' is not a port.")]
    [InlineData("studio:port", "'port' in 'studio:port' is not a port.")]
    [InlineData("udp://", "'udp://' has no port. Use udp://:PORT")]
    [InlineData("udp://7002", "'udp://7002' has no port.")]
    [InlineData("udp://studio", "'udp://studio' has no port.")]
    [InlineData("udp://:", "'udp://:' has no number after the colon.")]
    [InlineData("udp://:65536", "'65536' in 'udp://:65536' is not a port. A port is a number from 1 to 65535.")]
    [InlineData("udp://:-1", "'-1' in 'udp://:-1' is not a port.")]
    [InlineData("udp://studio:7002", "'studio' is not an address of this computer. Over UDP the server sends to this computer: use udp://:7002.")]
    [InlineData("udp://studio:", "'udp://studio:' has no number after the colon.")]
    public void What_is_not_an_address_is_refused_in_words(string address, string expected)
    {
        string message = Assert.Throws<FormatException>(() => Parse(address)).Message;
        Assert.StartsWith(expected, message, StringComparison.Ordinal);
    }

    /// <summary>Reads an address.</summary>
    /// <exception cref="FormatException">The text is not an address. The message is the one that users see.</exception>
    protected abstract Address Parse(string address);

    /// <summary>The result. Host is that of a server. LocalAddress is that of a port of this computer.</summary>
    protected sealed record Address(TransportKind Transport, string Host, int Port, IPAddress? LocalAddress);
}
