using System.Net;
using NeuronMocap.Commands;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Commands;

/// <summary>The end of the command channel on this computer.</summary>
public sealed class CommandAddressTests
{
    [Theory]
    [InlineData("127.0.0.1", "127.0.77.9")]
    [InlineData("::1", "::1")]
    public async Task The_client_connects_from_the_local_address(string host, string local)
    {
        if (host == "::1")
            Loopback.NeedIPv6();
        else
            Loopback.NeedManyAddresses();

        using var server = new TestServer(IPAddress.Parse(host));
        await using var client = new NeuronCommandClient(new NeuronCommandOptions { Host = host, Port = server.Port, LocalAddress = IPAddress.Parse(local) });
        Task asking = client.GetRotationOrderAsync(TestContext.Current.CancellationToken);
        using TestConnection connection = await server.AcceptAsync();
        Assert.Equal(IPAddress.Parse(local), ((IPEndPoint)connection.Socket.RemoteEndPoint!).Address);
        connection.Reset();
        await Assert.ThrowsAsync<NeuronCommandException>(() => asking.Soon());
    }

    [Theory]
    [InlineData("127.0.0.1", "::1")]
    [InlineData("::1", "127.0.0.1")]
    [InlineData("127.0.0.1", "192.0.2.77")]
    public async Task An_address_that_does_not_fit_is_named(string host, string local)
    {
        await using var client = new NeuronCommandClient(new NeuronCommandOptions { Host = host, Port = 1, LocalAddress = IPAddress.Parse(local) });
        NeuronCommandException failure = await Assert.ThrowsAsync<NeuronCommandException>(
            () => client.GetRotationOrderAsync(TestContext.Current.CancellationToken).Soon());
        Assert.Equal(CommandFailure.NotConnected, failure.Reason);
        Assert.Contains($"The local address {local} does not belong to this computer", failure.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void A_reader_asks_from_its_own_local_address_over_tcp_only()
    {
        var options = new NeuronReaderOptions { CommandPort = 8013, LocalAddress = IPAddress.IPv6Loopback };
        Assert.Equal(IPAddress.IPv6Loopback, options.Commands!.LocalAddress);
        options.Transport = TransportKind.Udp;
        Assert.Null(options.Commands!.LocalAddress);
    }
}
