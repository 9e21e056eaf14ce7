using System.Net;
using NeuronMocap.Tool.Arguments;
using NeuronMocap.Tool.Watch;

namespace NeuronMocap.Tool.Tests.Watch;

public sealed class WatchOptionsTests
{
    [Fact]
    public void The_reader_asks_the_command_port_of_the_server_that_is_shown()
    {
        var server = new ServerAddress("studio", 7003);
        NeuronReaderOptions options = new WatchOptions { Server = server, CommandPort = 8014 }.ToReaderOptions(server);

        Assert.Equal(("studio", 7003, 8014), (options.Host, options.Port, options.CommandPort));
        Assert.Equal(IPAddress.Loopback, new WatchOptions { Server = server, LocalAddress = IPAddress.Loopback }.ToReaderOptions(server).LocalAddress);
        Assert.Null(new WatchOptions { Server = server }.ToReaderOptions(server).CommandPort);
    }
}
