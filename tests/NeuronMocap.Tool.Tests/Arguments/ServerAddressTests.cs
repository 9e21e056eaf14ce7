using NeuronMocap.Tool.Arguments;

namespace NeuronMocap.Tool.Tests.Arguments;

public sealed class ServerAddressTests
{
    [Theory]
    [InlineData("studio", "studio", 7001)]
    [InlineData("studio:7003", "studio", 7003)]
    [InlineData("192.168.1.20", "192.168.1.20", 7001)]
    [InlineData("192.168.1.20:1", "192.168.1.20", 1)]
    [InlineData("[::1]:7001", "::1", 7001)]
    [InlineData("[::1]:65535", "::1", 65535)]
    [InlineData("[fe80::1%eth0]", "fe80::1%eth0", 7001)]
    [InlineData("::1", "::1", 7001)]
    [InlineData(" studio:9 ", "studio", 9)]
    public void Every_form_of_a_server_is_understood(string text, string host, int port)
    {
        Assert.True(ServerAddress.TryParse(text, out ServerAddress address, out string? error), error);
        Assert.Equal(new ServerAddress(host, port), address);
    }

    [Theory]
    [InlineData("")]
    [InlineData(":7001")]
    [InlineData("studio:")]
    [InlineData("studio:0")]
    [InlineData("studio:65536")]
    [InlineData("studio:-1")]
    [InlineData("studio:+1")]
    [InlineData("studio:http")]
    [InlineData("[::1]:")]
    [InlineData("[::1]7001")]
    [InlineData("[::1")]
    [InlineData("[studio:1]")]
    [InlineData("a:b:c")]
    [InlineData("two words")]
    [InlineData("http://studio")]
    public void An_invalid_server_is_refused_with_a_reason(string text)
    {
        Assert.False(ServerAddress.TryParse(text, out _, out string? error));
        Assert.NotEmpty(error);
    }

    [Theory]
    [InlineData("studio")]
    [InlineData("[::1]:7003")]
    public void The_text_of_an_address_round_trips(string text)
    {
        Assert.True(ServerAddress.TryParse(text, out ServerAddress address, out _));
        Assert.True(ServerAddress.TryParse(address.ToString(), out ServerAddress again, out _));
        Assert.Equal(address, again);
    }
}
