using NeuronMocap.Commands;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Reader;

public sealed class AddressParsingTests : AddressContract
{
    [Theory]
    [InlineData("")]
    [InlineData("http://studio")]
    [InlineData("studio/take")]
    [InlineData(@"takes\monday")]
    public void What_a_program_may_understand_otherwise_is_not_an_address(string address)
    {
        string message = Assert.Throws<FormatException>(() => NeuronReaderOptions.Parse(address)).Message;
        Assert.StartsWith($"'{address}' is not an address.", message, StringComparison.Ordinal);
    }

    [Fact]
    public void Any_free_UDP_port_is_zero()
    {
        var options = NeuronReaderOptions.Parse("udp://:0");
        Assert.Equal((TransportKind.Udp, 0), (options.Transport, options.Port));
    }

    [Theory]
    [InlineData("studio", "studio", 8013)]
    [InlineData("tcp://[::1]:8014/", "::1", 8014)]
    public void A_command_address_has_its_own_default_port(string address, string host, int port)
    {
        var options = NeuronCommandOptions.Parse(address);
        Assert.Equal((host, port), (options.Host, options.Port));
        Assert.StartsWith("'udp://:1' is not", Assert.Throws<FormatException>(() => NeuronCommandOptions.Parse("udp://:1")).Message, StringComparison.Ordinal);
    }

    protected override Address Parse(string address)
    {
        var options = NeuronReaderOptions.Parse(address);
        return new Address(options.Transport, options.Host, options.Port, options.LocalAddress);
    }
}
