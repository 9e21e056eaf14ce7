using System.Net;
using NeuronMocap.Tool.Arguments;

namespace NeuronMocap.Tool.Tests.Arguments;

public sealed class ConnectionOptionsTests
{
    [Fact]
    public void The_reader_asks_the_command_port_of_the_server_that_is_shown()
    {
        var server = new ServerAddress("studio", 7003);
        NeuronReaderOptions options = new ConnectionOptions { Server = server, CommandPort = 8014 }.ToReaderOptions(server);

        Assert.Equal(("studio", 7003, 8014), (options.Host, options.Port, options.CommandPort));
        Assert.Equal(IPAddress.Loopback, new ConnectionOptions { Server = server, LocalAddress = IPAddress.Loopback }.ToReaderOptions(server).LocalAddress);
        Assert.Null(new ConnectionOptions { Server = server }.ToReaderOptions(server).CommandPort);
    }
}
