using System.Net;
using NeuronMocap.Tool.Arguments;

namespace NeuronMocap.Tool.Tests.Arguments;

public sealed class SourceTests
{
    [Theory]
    [InlineData("studio", "studio", 7001)]
    [InlineData("studio/", "studio", 7001)]
    [InlineData("studio:7003", "studio", 7003)]
    [InlineData("192.168.1.20", "192.168.1.20", 7001)]
    [InlineData("tcp://studio", "studio", 7001)]
    [InlineData("tcp://192.168.1.20:7003/", "192.168.1.20", 7003)]
    [InlineData("TCP://[::1]:7003", "::1", 7003)]
    [InlineData("[::1]", "::1", 7001)]
    [InlineData("[fe80::1%eth0]:7003", "fe80::1%eth0", 7003)]
    [InlineData("::1", "::1", 7001)]
    [InlineData("tcp://demo", "demo", 7001)]
    [InlineData("tcp://take.nmrec", "take.nmrec", 7001)]
    public void A_server_may_be_given_without_the_transport(string text, string host, int port)
    {
        Source source = Parse(text);
        Assert.Equal(Source.OfServer(new ServerAddress(host, port)), source);
        Assert.Equal(source, Parse(source.ToString()));
    }

    [Theory]
    [InlineData("udp://:7012", null)]
    [InlineData("udp://:7012/", null)]
    [InlineData("udp://192.168.1.5:7012", "192.168.1.5")]
    [InlineData("udp://[::1]:7012", "::1")]
    public void A_UDP_port_may_have_an_address_of_this_computer(string text, string? address)
    {
        Source source = Parse(text);
        Assert.Equal(Source.OfUdp(7012, address is null ? null : IPAddress.Parse(address)), source);
        Assert.Equal(source, Parse(source.ToString()));
    }

    [Theory]
    [InlineData("take.nmrec")]
    [InlineData("missing.BIN")]
    [InlineData("dump.dat")]
    [InlineData("walk.bvh")]
    [InlineData("./studio")]
    [InlineData("takes/studio")]
    [InlineData("/tmp/")]
    [InlineData(@"takes\monday")]
    [InlineData("./demo")]
    public void A_file_name_is_a_file_even_if_missing(string text) => Assert.Equal(Source.OfFile(text), Parse(text));

    [Fact]
    public void An_existing_file_may_have_any_name()
    {
        string path = Path.GetFileName(Path.GetTempFileName());
        string here = Path.Combine(Directory.GetCurrentDirectory(), path[..^4]);
        File.WriteAllText(here, string.Empty);
        try
        {
            Assert.Equal(Source.OfFile(Path.GetFileName(here)), Parse(Path.GetFileName(here)));
        }
        finally
        {
            File.Delete(here);
            File.Delete(Path.Combine(Path.GetTempPath(), path));
        }
    }

    [Theory]
    [InlineData("demo")]
    [InlineData("DEMO")]
    public void Demo_is_the_built_in_simulator(string text) => Assert.Equal(Source.Demo, Parse(text));

    [Theory]
    [InlineData("udp://")]
    [InlineData("udp://:")]
    [InlineData("udp://:0")]
    [InlineData("udp://:65536")]
    [InlineData("udp://7012")]
    [InlineData("udp://studio:7012")]
    [InlineData("tcp://")]
    [InlineData("tcp://:7001")]
    [InlineData("ftp://studio")]
    [InlineData("http://studio/take.nmrec")]
    [InlineData("studio:port")]
    [InlineData("stu dio")]
    [InlineData("[::1")]
    [InlineData("")]
    [InlineData(" ")]
    public void An_invalid_source_is_refused_with_a_reason(string text)
    {
        Assert.False(Source.TryParse(text, out _, out string? error));
        Assert.NotEmpty(error);
    }

    [Theory]
    [InlineData("studio:70000")]
    [InlineData("udp://:70000")]
    [InlineData("udp://:70000/")]
    public void A_port_out_of_range_is_named_with_the_range(string text)
    {
        Assert.False(Source.TryParse(text, out _, out string? error));
        Assert.Equal("'70000' is no port: it must be a number from 1 to 65535.", error);
    }

    private static Source Parse(string text)
    {
        Assert.True(Source.TryParse(text, out Source? source, out string? error), error);
        return source;
    }
}
