using System.Diagnostics;
using System.Net.Sockets;
using NeuronMocap.Commands;
using NeuronMocap.Tests.Network;
using NeuronMocap.Tests.Server;

namespace NeuronMocap.Server.Tests;

public sealed class CommandRelayTests
{
    [Fact]
    public async Task Bytes_pass_unchanged_in_both_directions()
    {
        using var server = new TestServer();
        await using CommandRelay relay = Started(server.Port);
        using TestClient client = await TestClient.ConnectAsync(relay.LocalEndPoint);
        using TestConnection behind = await server.AcceptAsync();
        byte[] request = [1, 2, 3, 250];
        byte[] reply = [.. Enumerable.Range(0, 100_000).Select(static i => (byte)i)];
        await client.Socket.SendAsync(request);
        Assert.Equal(request, await ReadAsync(behind.Socket, request.Length));
        Task sending = behind.SendAsync(reply);
        Assert.Equal(reply, await ReadAsync(client.Socket, reply.Length));
        await sending;
    }

    [Fact]
    public async Task A_command_client_asks_a_command_server_through_it()
    {
        BroadcasterOptions options = Expect.Options(frames: 1);
        options.RotationOrder = RotationOrder.ZXY;
        await using Broadcaster broadcaster = Broadcasts.Started(options);
        await using var server = new CommandServer(broadcaster, new CommandServerOptions { Port = 0 });
        server.Start();
        await using CommandRelay relay = Started(server.LocalEndPoint!.Port);
        await using var client = new NeuronCommandClient(
            new NeuronCommandOptions { Port = relay.LocalEndPoint!.Port, Timeout = Limits.Unexpected, ConnectTimeout = Limits.Unexpected });
        Assert.Equal(RotationOrder.ZXY, await client.GetRotationOrderAsync(TestContext.Current.CancellationToken).Soon());
        Assert.Equal((1, 1), (relay.ClientCount, server.ClientCount));
    }

    [Fact]
    public async Task A_client_is_closed_when_the_server_is_gone()
    {
        using var server = new TestServer();
        await using CommandRelay relay = Started(server.Port);
        using TestClient client = await TestClient.ConnectAsync(relay.LocalEndPoint);
        using TestConnection behind = await server.AcceptAsync();
        behind.Close();
        Assert.Empty(await ReadAsync(client.Socket, 1));
        await Limits.UntilAsync(() => relay.ClientCount == 0);
    }

    [Fact]
    public async Task A_client_that_has_closed_its_side_still_gets_its_reply()
    {
        using var server = new TestServer();
        await using CommandRelay relay = Started(server.Port);
        using TestClient client = await TestClient.ConnectAsync(relay.LocalEndPoint);
        using TestConnection behind = await server.AcceptAsync();
        await client.Socket.SendAsync((byte[])[1]);
        client.Socket.Shutdown(SocketShutdown.Send);
        Assert.Equal([1], await ReadAsync(behind.Socket, 2));
        await behind.SendAsync((byte[])[2]);
        behind.Close();
        Assert.Equal([2], await ReadAsync(client.Socket, 2));
    }

    [Fact]
    public async Task The_limit_of_clients_holds_and_a_place_becomes_free_again()
    {
        using var server = new TestServer();
        await using CommandRelay relay = Started(server.Port, maxClients: 1, getTimestamp: static () => 0);
        TestClient first = await TestClient.ConnectAsync(relay.LocalEndPoint);
        using TestConnection behind = await server.AcceptAsync();
        using (TestClient second = await TestClient.ConnectAsync(relay.LocalEndPoint))
            Assert.Empty(await ReadAsync(second.Socket, 1));

        first.Reset();
        await Limits.UntilAsync(() => relay.ClientCount == 0);
        using TestClient third = await TestClient.ConnectAsync(relay.LocalEndPoint);
        using TestConnection next = await server.AcceptAsync();
        await next.SendAsync((byte[])[7]);
        Assert.Equal([7], await ReadAsync(third.Socket, 1));
    }

    [Fact]
    public async Task A_full_relay_drops_the_client_that_has_been_idle_the_longest()
    {
        long now = 0;
        using var server = new TestServer();
        await using CommandRelay relay = Started(server.Port, maxClients: 2, getTimestamp: () => Volatile.Read(ref now));
        using TestClient asked = await TestClient.ConnectAsync(relay.LocalEndPoint);
        using TestConnection behindAsked = await server.AcceptAsync();
        await asked.Socket.SendAsync((byte[])[1]);
        Assert.Equal([1], await ReadAsync(behindAsked.Socket, 1));
        Interlocked.Add(ref now, 10 * Stopwatch.Frequency);
        using TestClient silent = await TestClient.ConnectAsync(relay.LocalEndPoint);
        using TestConnection behindSilent = await server.AcceptAsync();
        await behindSilent.SendAsync((byte[])[4]);
        Assert.Equal([4], await ReadAsync(silent.Socket, 1));
        Interlocked.Add(ref now, 3 * Stopwatch.Frequency);
        using TestClient third = await TestClient.ConnectAsync(relay.LocalEndPoint);
        Assert.Empty(await ReadAsync(silent.Socket, 1));
        Assert.Empty(await ReadAsync(behindSilent.Socket, 1));
        using TestConnection behindThird = await server.AcceptAsync();
        await behindThird.SendAsync((byte[])[3]);
        Assert.Equal([3], await ReadAsync(third.Socket, 1));
        await behindAsked.SendAsync((byte[])[2]);
        Assert.Equal([2], await ReadAsync(asked.Socket, 1));
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public async Task A_connection_that_passes_nothing_is_closed_after_the_idle_time(bool isServerActive)
    {
        long now = 0;
        int reads = 0;
        using var server = new TestServer();
        await using CommandRelay relay = Started(server.Port, idleTimeout: TimeSpan.FromSeconds(1), getTimestamp: ReadTime);
        using TestClient client = await TestClient.ConnectAsync(relay.LocalEndPoint);
        using TestConnection behind = await server.AcceptAsync();
        for (int i = 0; i < 3; i++)
        {
            (Socket from, Socket to) = isServerActive ? (behind.Socket, client.Socket) : (client.Socket, behind.Socket);
            await from.SendAsync((byte[])[(byte)i]);
            Assert.Equal([(byte)i], await ReadAsync(to, 1));
            Interlocked.Add(ref now, Stopwatch.Frequency * 3 / 4);
        }

        // The relay has looked at the clock again, and the connection still passes bytes.
        int before = Volatile.Read(ref reads);
        await Limits.UntilAsync(() => Volatile.Read(ref reads) > before + 1);
        await client.Socket.SendAsync((byte[])[9]);
        Assert.Equal([9], await ReadAsync(behind.Socket, 1));
        Interlocked.Add(ref now, Stopwatch.Frequency);
        Assert.Empty(await ReadAsync(client.Socket, 1));
        Assert.Empty(await ReadAsync(behind.Socket, 1));
        await Limits.UntilAsync(() => relay.ClientCount == 0);

        long ReadTime()
        {
            Interlocked.Increment(ref reads);
            return Volatile.Read(ref now);
        }
    }

    [Fact]
    public async Task A_stop_closes_both_ends()
    {
        using var server = new TestServer();
        await using CommandRelay relay = Started(server.Port);
        using TestClient client = await TestClient.ConnectAsync(relay.LocalEndPoint);
        using TestConnection behind = await server.AcceptAsync();
        relay.Stop();
        Assert.Empty(await ReadAsync(behind.Socket, 1));
        Assert.Empty(await ReadAsync(client.Socket, 1));
        Assert.Throws<ObjectDisposedException>(relay.Start);
    }

    [Fact]
    public async Task A_server_that_cannot_be_reached_is_reported()
    {
        int port;
        using (var server = new TestServer())
            port = server.Port;

        var reported = new TaskCompletionSource<Exception>();
        await using var relay = new CommandRelay(new CommandRelayOptions { Host = "127.0.0.1", HostPort = port, Port = 0 });
        relay.Failed += exception => reported.TrySetResult(exception);
        relay.Start();
        using TestClient client = await TestClient.ConnectAsync(relay.LocalEndPoint);
        Assert.Empty(await ReadAsync(client.Socket, 1));
        Assert.StartsWith($"The command channel of 127.0.0.1:{port} ", (await reported.Task.Soon()).Message, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_relay_does_not_connect_to_itself()
    {
        int port;
        using (var server = new TestServer())
            port = server.Port;

        var reported = new TaskCompletionSource<Exception>();
        await using var relay = new CommandRelay(new CommandRelayOptions { Host = "127.0.0.1", HostPort = port, Port = port });
        relay.Failed += exception => reported.TrySetResult(exception);
        relay.Start();
        using TestClient client = await TestClient.ConnectAsync(relay.LocalEndPoint);
        Assert.Contains("this relay itself", (await reported.Task.Soon()).Message, StringComparison.Ordinal);
        await Limits.UntilAsync(() => relay.ClientCount == 0);
    }

    [Fact]
    public void Wrong_settings_are_refused_by_name()
    {
        using var server = new TestServer();
        using var relay = new CommandRelay(new CommandRelayOptions { Host = "studio", Port = server.Port });
        Assert.Equal(nameof(CommandRelayOptions.Port), Assert.Throws<BroadcasterException>(relay.Start).Setting);
        AssertRefused(nameof(CommandRelayOptions.Host), new CommandRelayOptions());
        AssertRefused(nameof(CommandRelayOptions.Host), new CommandRelayOptions { Host = "[::1]:8013" });
        AssertRefused(nameof(CommandRelayOptions.Host), new CommandRelayOptions { Host = "studio:8013" });
        AssertRefused(nameof(CommandRelayOptions.HostPort), new CommandRelayOptions { Host = "studio", HostPort = 0 });
        AssertRefused(nameof(CommandRelayOptions.Port), new CommandRelayOptions { Host = "studio", Port = -1 });
        AssertRefused(nameof(CommandRelayOptions.MaxClients), new CommandRelayOptions { Host = "studio", MaxClients = 0 });
        AssertRefused(nameof(CommandRelayOptions.ConnectTimeout), new CommandRelayOptions { Host = "studio", ConnectTimeout = TimeSpan.Zero });
        AssertRefused(nameof(CommandRelayOptions.IdleTimeout), new CommandRelayOptions { Host = "studio", IdleTimeout = TimeSpan.FromMilliseconds(999) });

        static void AssertRefused(string setting, CommandRelayOptions options) =>
            Assert.Equal(setting, Assert.Throws<ArgumentException>(() => new CommandRelay(options)).ParamName);
    }

    private static CommandRelay Started(int port, int maxClients = 32, TimeSpan? idleTimeout = null, Func<long>? getTimestamp = null)
    {
        var options = new CommandRelayOptions { Host = "127.0.0.1", HostPort = port, Port = 0, MaxClients = maxClients };
        options.IdleTimeout = idleTimeout ?? options.IdleTimeout;
        var relay = new CommandRelay(options) { GetTimestamp = getTimestamp ?? Stopwatch.GetTimestamp };
        relay.Start();
        return relay;
    }

    // Returns fewer bytes at the end of the connection. A reset is an end, too.
    private static async Task<byte[]> ReadAsync(Socket socket, int length)
    {
        byte[] bytes = new byte[length];
        int received = 0;
        try
        {
            int count;
            while (received < length && (count = await socket.ReceiveAsync(bytes.AsMemory(received), TestContext.Current.CancellationToken).Soon()) > 0)
                received += count;
        }
        catch (SocketException exception) when (exception.SocketErrorCode is SocketError.ConnectionReset or SocketError.ConnectionAborted)
        {
            // The end.
        }

        return bytes[..received];
    }
}
