using System.Net;
using System.Net.Sockets;
using NeuronMocap.Tests.Network;
using NeuronMocap.Transport;

namespace NeuronMocap.Tests.Reader;

// Names with several addresses, and IPv6.
public sealed class AddressTests
{
    [Fact]
    public async Task Localhost_is_found_on_both_addresses()
    {
        using var server = new TestServer();
        NeuronReaderOptions options = server.Options();
        options.Host = "localhost";
        await AssertReceivesAsync(new NeuronReader(options), server);
    }

    [Theory]
    [InlineData("::1")]
    [InlineData("[::1]")]
    [InlineData("localhost")]
    public async Task A_server_on_ipv6_is_found(string host)
    {
        Loopback.NeedIPv6();
        Assert.SkipUnless(
            host != "localhost" || (await Dns.GetHostAddressesAsync(host)).Contains(IPAddress.IPv6Loopback), "The name localhost has no IPv6 address here.");
        using var server = new TestServer(IPAddress.IPv6Loopback);
        NeuronReaderOptions options = server.Options();
        options.Host = host;
        await AssertReceivesAsync(new NeuronReader(options), server);
    }

    [Fact]
    public async Task A_silent_address_is_skipped_for_a_working_one()
    {
        Loopback.NeedManyAddresses();
        using var blackHole = new BlackHole();
        using var server = new TestServer(IPAddress.Parse("127.0.77.3"), blackHole.Port);
        var options = new LinkOptions("suit-pc", blackHole.Port)
        {
            ConnectTimeout = TimeSpan.FromSeconds(4), // the working address has the same limit
            Resolve = _ => Task.FromResult<IPAddress[]>([IPAddress.Loopback, IPAddress.Parse("127.0.77.3")]),
        };
        await AssertReceivesAsync(new NeuronReader(server.Options(), () => new TcpLink(options)), server);
    }

    [Fact]
    public async Task A_name_is_looked_up_again_for_every_attempt()
    {
        Loopback.NeedManyAddresses();
        using var server = new TestServer(IPAddress.Parse("127.0.77.4"));
        int asked = 0;
        var options = new LinkOptions("suit-pc", server.Port)
        {
            // The computer got another address in the meantime.
            Resolve = _ => Task.FromResult<IPAddress[]>([IPAddress.Parse(++asked < 3 ? "127.0.77.5" : "127.0.77.4")]),
        };
        await AssertReceivesAsync(new NeuronReader(server.Options(reconnect: true), () => new TcpLink(options)), server);
        Assert.Equal(3, asked);
    }

    [Fact]
    public void A_socket_that_connected_to_itself_is_recognised()
    {
        using var socket = new Socket(AddressFamily.InterNetwork, SocketType.Stream, ProtocolType.Tcp);
        socket.Bind(new IPEndPoint(IPAddress.Loopback, 0));
        try
        {
            socket.Connect(socket.LocalEndPoint!);
        }
        catch (SocketException)
        {
            Assert.Skip("This system does not let a socket connect to itself.");
        }

        Assert.True(TcpLink.IsOwnEcho(socket, socket.RemoteEndPoint!));
    }

    [Fact]
    public void A_connection_to_a_server_is_no_self_connection()
    {
        using var server = new TestServer();
        using var socket = new Socket(AddressFamily.InterNetwork, SocketType.Stream, ProtocolType.Tcp);
        socket.Connect(IPAddress.Loopback, server.Port);
        Assert.False(TcpLink.IsOwnEcho(socket, socket.RemoteEndPoint!));
    }

    [Theory]
    [InlineData(TransportKind.Tcp, 0)]
    [InlineData(TransportKind.Tcp, 65536)]
    [InlineData(TransportKind.Udp, -1)]
    public void A_calculation_port_out_of_range_is_refused(TransportKind transport, int port)
    {
        var options = new NeuronReaderOptions { Transport = transport, CalculationPort = port };
        Assert.Contains("CalculationPort", Assert.Throws<ArgumentException>(() => new NeuronReader(options)).Message, StringComparison.Ordinal);
    }

    private static async Task AssertReceivesAsync(NeuronReader reader, TestServer server)
    {
        await using (reader)
        {
            reader.Start();
            using TestConnection connection = await server.AcceptAsync();
            await connection.SendAsync(TestPackets.Motion(1));
            await reader.WaitForFramesAsync(1);

            // Before the connection ends, and the reader looks for another.
            await reader.DisposeAsync();
        }
    }
}
