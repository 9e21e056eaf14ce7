using System.Net;
using NeuronMocap.Tool.Arguments;

namespace NeuronMocap.Tool.Tests.Arguments;

public sealed class SourceAddressTests
{
    [Theory]
    [InlineData("studio", "studio", 7001)]
    [InlineData("studio:7003", "studio", 7003)]
    [InlineData("tcp://studio", "studio", 7001)]
    [InlineData("tcp://192.168.1.20:7003/", "192.168.1.20", 7003)]
    [InlineData("TCP://[::1]:7003", "::1", 7003)]
    public void A_server_is_named_with_and_without_the_transport(string text, string host, int port)
    {
        Assert.True(SourceAddress.TryParse(text, out SourceAddress source, out string? error), error);
        Assert.Equal(new SourceAddress(new ServerAddress(host, port), UdpPort: null, LocalAddress: null), source);
    }

    [Theory]
    [InlineData("udp://:7012", null)]
    [InlineData("udp://:7012/", null)]
    [InlineData("udp://192.168.1.5:7012", "192.168.1.5")]
    [InlineData("udp://[::1]:7012", "::1")]
    public void A_UDP_port_may_have_an_address_of_this_computer(string text, string? address)
    {
        Assert.True(SourceAddress.TryParse(text, out SourceAddress source, out string? error), error);
        Assert.Equal(new SourceAddress(Server: null, 7012, address is null ? null : IPAddress.Parse(address)), source);
    }

    [Theory]
    [InlineData("udp://")]
    [InlineData("udp://:")]
    [InlineData("udp://:0")]
    [InlineData("udp://7012")]
    [InlineData("udp://studio:7012")]
    [InlineData("tcp://")]
    [InlineData("tcp://:7001")]
    [InlineData("ftp://studio")]
    [InlineData("")]
    public void What_is_no_source_is_refused_with_a_reason(string text)
    {
        Assert.False(SourceAddress.TryParse(text, out _, out string? error));
        Assert.NotEmpty(error);
    }
}
