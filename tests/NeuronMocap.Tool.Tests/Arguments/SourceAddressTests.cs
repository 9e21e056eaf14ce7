using NeuronMocap.Tests.Network;
using NeuronMocap.Tool.Arguments;
using NeuronMocap.Tool.Relay.Destinations;

namespace NeuronMocap.Tool.Tests.Arguments;

public sealed class SourceAddressTests : AddressContract
{
    [Theory]
    [InlineData("studio")]
    [InlineData("tcp://[fe80::1%2]:7003")]
    [InlineData("tls://studio:7443")]
    [InlineData("tls://[::1]:7443")]
    [InlineData("ws://studio:7100")]
    [InlineData("wss://studio/motion")]
    [InlineData("udp://:7012")]
    [InlineData("udp://192.168.1.5:7012")]
    [InlineData("udp://[::1]:7012")]
    [InlineData("vmc://:39539")]
    [InlineData("VMC://[::1]:39539")]
    public void The_text_of_a_source_means_the_same_source(string text)
    {
        Source source = Read(text);
        Assert.Equal(source, Read(source.ToString()));
    }

    [Theory]
    [InlineData("")]
    [InlineData(" ")]
    [InlineData("ftp://studio")]
    [InlineData("http://studio/take.nmrec")]
    public void What_is_no_source_is_told_every_form_of_one(string text)
    {
        string message = Assert.Throws<FormatException>(() => Read(text)).Message;
        Assert.Equal($"'{text}' is not a source. Use HOST, HOST:PORT, tcp://HOST:PORT, tls://HOST:PORT, ws://HOST:PORT, udp://:PORT, vmc://:PORT, amqp://USER:PASSWORD@HOST, a file, or demo.", message);
    }

    [Theory]
    [InlineData("ws://")]
    [InlineData("ws://:7100")]
    [InlineData("ws://studio:70000")]
    [InlineData("ws://user@studio:7100")]
    public void What_is_no_WebSocket_is_refused(string text)
    {
        string message = Assert.Throws<FormatException>(() => Read(text)).Message;
        Assert.Equal($"'{text}' is not the address of a WebSocket. Use ws://HOST:PORT.", message);
    }

    [Theory]
    [InlineData("me:secret@broker")]
    [InlineData("me:secret@broker:5672")]
    [InlineData("amqp:/me:secret@broker")]
    [InlineData("amqps://me:secret@broker")]
    [InlineData("amqp://me:secret")]
    [InlineData("amqp://me:12/secret@broker")]
    public void A_password_in_a_wrong_address_is_not_shown(string text)
    {
        Assert.False(Source.TryParse(text, out _, out string? sourceError));
        Assert.False(Destination.TryParse(text, out _, out string? destinationError));

        Assert.DoesNotContain("secret", sourceError + destinationError);
    }

    [Fact]
    public void A_token_is_not_shown() => Assert.Equal("ws://studio:7100", Read("ws://studio:7100?token=secret").ToString());

    // The library chooses any free port. Here nothing could send to it.
    [Theory]
    [InlineData("udp://:0")]
    [InlineData("udp://127.0.0.1:00")]
    public void A_UDP_port_that_nobody_knows_is_refused(string text)
    {
        string message = Assert.Throws<FormatException>(() => Read(text)).Message;
        Assert.Equal($"'{text}' has no port that a server could send to. Use udp://:PORT with a port from 1 to 65535.", message);
    }

    [Theory]
    [InlineData("vmc://39539")]
    [InlineData("vmc://:0")]
    [InlineData("vmc://:65536")]
    [InlineData("vmc://studio:39539")]
    public void A_VMC_port_that_cannot_be_is_refused(string text)
    {
        string message = Assert.Throws<FormatException>(() => Read(text)).Message;
        Assert.Equal($"'{text}' has no port that a program could send to. Use vmc://:PORT with a port from 1 to 65535; the port is 39539 if it is left out.", message);
    }

    [Theory]
    [InlineData("vmc://", "vmc://:39539")]
    [InlineData("vmc://192.168.1.5", "vmc://192.168.1.5:39539")]
    [InlineData("vmc://[::1]", "vmc://[::1]:39539")]
    public void VMC_has_a_usual_port(string text, string expected) => Assert.Equal(expected, Read(text).ToString());

    protected override Address Parse(string address)
    {
        Source source = Read(address);
        return source.Server is { } server
            ? new Address(TransportKind.Tcp, server.Host, server.Port, source.LocalAddress)
            : new Address(TransportKind.Udp, string.Empty, source.UdpPort!.Value, source.LocalAddress);
    }

    private static Source Read(string text) => Source.TryParse(text, out Source? source, out string? error) ? source : throw new FormatException(error);
}
