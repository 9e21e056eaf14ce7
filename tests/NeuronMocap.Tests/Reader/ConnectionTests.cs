using System.Net;
using System.Net.Sockets;
using System.Text;
using NeuronMocap.Protocol;
using NeuronMocap.Tests.Network;
using NeuronMocap.Transport;

namespace NeuronMocap.Tests.Reader;

public sealed class ConnectionTests
{
    [Fact]
    public async Task A_refused_connection_names_the_setting()
    {
        int port = FreePort.Next();
        await using var reader = new NeuronReader(new NeuronReaderOptions { Port = port, Reconnect = { Enabled = false } });
        NeuronConnectionException exception = await Assert.ThrowsAsync<NeuronConnectionException>(() => reader.StartAsync().Soon());
        Assert.Equal(ConnectionReason.Refused, exception.Reason);
        Assert.Contains($"127.0.0.1:{port}", exception.Message, StringComparison.Ordinal);
        Assert.Contains("Axis Neuron", exception.Message, StringComparison.Ordinal);
        await reader.Completion.Soon();
        Assert.Equal((ConnectionState.Stopped, ConnectionReason.Refused), (reader.Status.State, reader.Status.Reason));
    }

    [Fact]
    public async Task A_reset_connection_is_reported()
    {
        using var server = new TestServer();
        await using var reader = new NeuronReader(server.Options());
        await StartedAsync(reader, server, connection => connection.Reset());
        await reader.Completion.Soon();
        Assert.Equal(ConnectionReason.Reset, reader.Status.Reason);
    }

    [Fact]
    public async Task States_follow_each_other_from_start_to_stop()
    {
        using var server = new TestServer();
        await using var reader = new NeuronReader(server.Options());
        var log = new StatusLog(reader);
        reader.Start();
        using TestConnection connection = await server.AcceptAsync();
        await connection.SendAsync(TestPackets.Motions(0, 3));
        ConnectionStatus receiving = await log.WaitAsync(ConnectionState.Receiving);
        Assert.Equal(server.Port, ((IPEndPoint)receiving.RemoteEndPoint!).Port);
        Assert.NotNull(receiving.LocalEndPoint);
        reader.Dispose();

        Assert.Equal(
            [ConnectionState.Connecting, ConnectionState.Connected, ConnectionState.Receiving, ConnectionState.Stopped],
            log.All.Select(status => status.State));
        Assert.Equal(ConnectionReason.Requested, log.All[^1].Reason);
    }

    [Fact]
    public async Task A_silent_server_and_an_unknown_format_are_distinguished()
    {
        using var server = new TestServer();
        NeuronReaderOptions options = server.Options();
        options.SilenceTimeout = TimeSpan.FromMilliseconds(100);
        await using var reader = new NeuronReader(options);
        var log = new StatusLog(reader);
        reader.Start();
        using TestConnection connection = await server.AcceptAsync();
        await log.WaitAsync(status => status is { State: ConnectionState.Silent, Reason: ConnectionReason.NoData });
        await connection.SendAsync(Encoding.ASCII.GetBytes("0 Char00 0.00 93.02 0.00 ||\r\n"));
        ConnectionStatus unknown = await log.WaitAsync(status => status is { State: ConnectionState.Silent, Reason: ConnectionReason.UnknownFormat });
        Assert.Contains("Binary", unknown.Message, StringComparison.Ordinal);
        await connection.SendAsync(TestPackets.Motion(1));
        await log.WaitAsync(ConnectionState.Receiving);
    }

    [Fact]
    public async Task A_server_of_another_protocol_that_closes_is_named()
    {
        using var server = new TestServer();
        await using var reader = new NeuronReader(server.Options());
        reader.Start();
        using TestConnection connection = await server.AcceptAsync();
        await connection.SendAsync(Encoding.ASCII.GetBytes("HTTP/1.1 400 Bad Request\r\n\r\n"));
        connection.Close();
        await reader.Completion.Soon();
        Assert.Equal(ConnectionReason.UnknownFormat, reader.Status.Reason);
        Assert.Contains("web server", reader.Status.Message, StringComparison.Ordinal);
    }

    [Fact]
    public async Task An_ipv6_address_is_written_in_brackets()
    {
        var options = new LinkOptions("::1", 9) { LocalAddress = IPAddress.Loopback };
        using var link = new TcpLink(options);
        Assert.Equal("[::1]:9", link.Target);
        Assert.Contains("[::1]:9", (await link.OpenAsync(CancellationToken.None).Soon()).Message, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_reader_reconnects_after_every_kind_of_end()
    {
        using var server = new TestServer();
        await using var reader = new NeuronReader(server.Options(reconnect: true));
        var log = new StatusLog(reader);
        List<uint?> indices = [];
        reader.MotionReceived += frame => indices.Add(frame.FrameIndex);
        reader.Start();
        for (int round = 0; round < 20; round++)
        {
            using TestConnection connection = await server.AcceptAsync();
            await connection.SendAsync(TestPackets.Join(TestPackets.Motions(round * 100, 3), TestPackets.Motion(0)[..700]));
            await reader.WaitForFramesAsync((round + 1) * 3);
            if (round % 2 == 0)
                connection.Close();
            else
                connection.Reset();
        }

        Assert.Equal(Enumerable.Range(0, 20).SelectMany(round => new uint?[] { (uint)round * 100, ((uint)round * 100) + 1, ((uint)round * 100) + 2 }), indices);
        await log.WaitAsync(status => status is { State: ConnectionState.Waiting, Reason: ConnectionReason.ClosedByPeer });
        await log.WaitAsync(status => status is { State: ConnectionState.Waiting, Reason: ConnectionReason.Reset });
        Assert.Equal(0, reader.GetStatistics().Lost);
    }

    [Fact]
    public async Task A_server_that_closes_at_once_is_retried_after_a_delay()
    {
        using var server = new TestServer();
        await using var reader = new NeuronReader(server.Options(reconnect: true));
        var log = new StatusLog(reader);
        reader.Start();
        for (int i = 0; i < 3; i++)
            (await server.AcceptAsync()).Close();

        ConnectionStatus third = await log.WaitAsync(status => status is { State: ConnectionState.Waiting, Attempt: 3 });
        Assert.True(third.RetryIn > TimeSpan.Zero);
        Assert.DoesNotContain(log.All, status => status.State == ConnectionState.Waiting && status.RetryIn == TimeSpan.Zero);
    }

    [Fact]
    public async Task An_unexpected_failure_is_retried()
    {
        using var server = new TestServer();
        int links = 0;
        NeuronReaderOptions options = server.Options(reconnect: true);
        await using var reader = new NeuronReader(options, () => ++links == 1 ? new BrokenLink() : new TcpLink(options.Link));
        var log = new StatusLog(reader);
        reader.Start();
        ConnectionStatus failed = await log.WaitAsync(ConnectionState.Waiting);
        Assert.Equal(ConnectionReason.NetworkError, failed.Reason);
        Assert.Contains(nameof(InvalidOperationException), failed.Message, StringComparison.Ordinal);
        using TestConnection connection = await server.AcceptAsync();
        await connection.SendAsync(TestPackets.Motion(1));
        await log.WaitAsync(ConnectionState.Receiving);
    }

    [Fact]
    public async Task A_server_that_sends_one_frame_and_closes_is_not_hammered()
    {
        using var server = new TestServer();
        await using var reader = new NeuronReader(server.Options(reconnect: true));
        var log = new StatusLog(reader);
        reader.Start();
        for (int i = 0; i < 3; i++)
        {
            using TestConnection connection = await server.AcceptAsync();
            await connection.SendAsync(TestPackets.Motion(i));
            connection.Close();
        }

        await Limits.UntilAsync(() => log.All.Count(status => status.State == ConnectionState.Waiting) >= 3);
        Assert.DoesNotContain(log.All, status => status.RetryIn == TimeSpan.Zero);
    }

    [Fact]
    public async Task A_server_that_comes_later_is_found()
    {
        int port = FreePort.Next();
        NeuronReaderOptions options = new()
        {
            Port = port,
            Reconnect = { InitialDelay = TimeSpan.FromMilliseconds(1), MaxDelay = TimeSpan.FromMilliseconds(2) },
        };
        await using var reader = new NeuronReader(options);
        var log = new StatusLog(reader);
        reader.Start();
        await log.WaitAsync(status => status is { State: ConnectionState.Waiting, Reason: ConnectionReason.Refused });
        using var listener = new TcpListener(IPAddress.Loopback, port);
        listener.Start();
        using var connection = new TestConnection(await listener.AcceptSocketAsync().Soon());
        await connection.SendAsync(TestPackets.Motion(1));
        await log.WaitAsync(ConnectionState.Receiving);
    }

    [Theory]
    [InlineData("")]
    [InlineData("  ")]
    public void An_empty_host_is_refused(string host) =>
        Assert.Contains("Host", Assert.Throws<ArgumentException>(() => new NeuronReader(host)).Message, StringComparison.Ordinal);

    [Theory]
    [InlineData(0)]
    [InlineData(-1)]
    [InlineData(65_536)]
    public void A_port_out_of_range_is_refused(int port) =>
        Assert.Contains("65535", Assert.Throws<ArgumentException>(() => new NeuronReader("127.0.0.1", port)).Message, StringComparison.Ordinal);

    private static async Task StartedAsync(NeuronReader reader, TestServer server, Action<TestConnection> end)
    {
        reader.Start();
        using TestConnection connection = await server.AcceptAsync();
        await connection.SendAsync(TestPackets.Motion(1));
        await reader.WaitForFramesAsync(1);
        end(connection);
    }

    private sealed class BrokenLink : Link
    {
        public override string Target => "nowhere";

        public override ReceiveThread ReceiveThread => ReceiveThread.Dedicated;

        public override Task<LinkEnd> OpenAsync(CancellationToken cancellationToken) => throw new InvalidOperationException("no descriptor");

        public override Task<LinkEnd> ReceiveAsync(IPacketReceiver receiver, ILinkListener? listener) => throw new InvalidOperationException();

        public override void Close()
        {
        }
    }
}
