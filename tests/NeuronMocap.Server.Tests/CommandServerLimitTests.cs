using System.Diagnostics;
using System.Net.Sockets;
using NeuronMocap.Commands;
using NeuronMocap.Tests.Commands;
using static NeuronMocap.Server.Tests.CommandServerTests;

namespace NeuronMocap.Server.Tests;

// Clients that ask too much, too many clients, and clients that ask nothing.
public sealed class CommandServerLimitTests
{
    [Theory]
    [InlineData(-1)]
    [InlineData(int.MaxValue)]
    [InlineData(1025)]
    public async Task A_request_that_announces_too_much_closes_its_connection_and_no_other(int size)
    {
        using Broadcaster broadcaster = CreateBroadcaster();
        using CommandServer server = Start(broadcaster);
        using Socket socket = Connect(server);
        socket.Send(CommandScript.Packet([], 1004, size));
        Assert.Empty(await ReadAsync(socket, 1));

        using NeuronCommandClient client = CreateClient(server);
        Assert.Equal(RotationOrder.YXZ, await client.GetRotationOrderAsync().Soon());
    }

    [Fact]
    public async Task Random_bytes_end_nothing()
    {
        using Broadcaster broadcaster = CreateBroadcaster();
        using CommandServer server = Start(broadcaster);
        var random = new Random(6);
        for (int i = 0; i < 30; i++)
        {
            using Socket socket = Connect(server);
            byte[] bytes = new byte[random.Next(1, 3000)];
            random.NextBytes(bytes);
            if (i % 2 == 0)
                CommandScript.Packet([], random.Next(65_536), random.Next(-10, 4000)).CopyTo(bytes.AsSpan(0, Math.Min(bytes.Length, 16)));
            socket.Send(bytes);
            if (i % 3 == 0)
                socket.LingerState = new LingerOption(enable: true, seconds: 0);
        }

        using NeuronCommandClient client = CreateClient(server);
        Assert.Equal(RotationOrder.YXZ, await client.GetRotationOrderAsync().Soon());
        await Limits.UntilAsync(() => server.ClientCount <= 1);
    }

    [Fact]
    public async Task Many_clients_are_served_at_once_and_those_beyond_the_limit_are_closed()
    {
        using Broadcaster broadcaster = CreateBroadcaster();
        using CommandServer server = Start(broadcaster, options => options.MaxClients = 8, getTimestamp: static () => 0);
        NeuronCommandClient[] clients = [.. Enumerable.Range(0, 8).Select(_ => CreateClient(server))];
        await Task.WhenAll(clients.Select(client => client.GetRotationOrderAsync())).Soon();
        await Limits.UntilAsync(() => server.ClientCount == 8);

        using Socket socket = Connect(server);
        Assert.Empty(await ReadAsync(socket, 1));
        foreach (NeuronCommandClient client in clients)
            client.Dispose();
        await Limits.UntilAsync(() => server.ClientCount == 0);
        using NeuronCommandClient next = CreateClient(server);
        await next.GetRotationOrderAsync().Soon();
    }

    // A client reconnects for most commands. Here the thread of its old connection is blocked, so that it notices the end too late.
    [Fact]
    public async Task A_reconnecting_client_has_room_before_its_old_connection_closes()
    {
        using var held = new ManualResetEventSlim();
        int sessions = 0;
        using Broadcaster broadcaster = CreateBroadcaster();
        using CommandServer server = Start(broadcaster, options => (options.MaxClients, options.IdleTimeout) = (1, TimeSpan.FromHours(1)), HoldFirst);
        using (Connect(server))
            await Limits.UntilAsync(() => Volatile.Read(ref sessions) == 1);

        using NeuronCommandClient client = CreateClient(server);
        await client.GetRotationOrderAsync().Soon();
        held.Set();
        await Limits.UntilAsync(() => server.ClientCount == 1);
        await client.GetRotationOrderAsync().Soon();

        // The session reads the time before it waits for a request.
        long HoldFirst()
        {
            if (Thread.CurrentThread.Name == "NeuronMocap commands" && Interlocked.Increment(ref sessions) == 1)
                held.Wait(Limits.Unexpected);

            return 0;
        }
    }

    // Idle connections cannot block others. A connection that never asked gives way first, then the connection that has been idle the longest.
    [Fact]
    public async Task A_full_server_drops_the_oldest_idle_client()
    {
        long now = 0;
        int reads = 0;
        using Broadcaster broadcaster = CreateBroadcaster();
        using CommandServer server = Start(broadcaster, options => options.MaxClients = 3, ReadTime);
        using NeuronCommandClient asked = CreateClient(server);
        await asked.GetRotationOrderAsync().Soon();

        // The client may have the answer before its session notes the time. The session reads it as it begins, before each wait, and after the answer.
        await Limits.UntilAsync(() => Volatile.Read(ref reads) >= 4);
        Pass(10);
        using Socket first = Connect(server);
        await Limits.UntilAsync(() => server.ClientCount == 2);
        Pass(1);
        using Socket second = Connect(server);
        await Limits.UntilAsync(() => server.ClientCount == 3);

        // First has been idle for 4 seconds and second for 3. That is less than the connection that asked, which stays nevertheless.
        Pass(3);
        using NeuronCommandClient third = CreateClient(server);
        await third.GetRotationOrderAsync().Soon();
        await IsClosedAsync(first);
        Assert.Equal(3, server.ClientCount);
        using NeuronCommandClient fourth = CreateClient(server);
        await fourth.GetRotationOrderAsync().Soon();
        await IsClosedAsync(second);

        // Now all have asked, and first is the one that asked longest ago.
        using Socket fifth = Connect(server);
        fifth.Send(CommandScript.Packet([], 1003));
        Assert.Equal(20, (await ReadAsync(fifth, 20)).Length);
        Assert.Equal(3, server.ClientCount);

        // None of the remaining connections has been idle for long.
        using Socket sixth = Connect(server);
        Assert.Empty(await ReadAsync(sixth, 1));
        await third.GetRotationOrderAsync().Soon();
        await fourth.GetRotationOrderAsync().Soon();

        void Pass(int seconds) => Interlocked.Add(ref now, seconds * Stopwatch.Frequency);

        long ReadTime()
        {
            Interlocked.Increment(ref reads);
            return Volatile.Read(ref now);
        }
    }

    [Fact]
    public async Task A_client_that_sends_only_garbage_is_closed_after_the_idle_time()
    {
        long now = 0;
        using Broadcaster broadcaster = CreateBroadcaster();
        using CommandServer server = Start(broadcaster, options => options.IdleTimeout = TimeSpan.FromHours(1), () => Volatile.Read(ref now));
        using Socket idle = Connect(server);
        using Socket active = Connect(server);
        byte[] request = CommandScript.Packet([], 1003);
        for (int i = 0; i < 3; i++)
        {
            active.Send(request);
            Assert.Equal(20, (await ReadAsync(active, 20)).Length);
            Interlocked.Add(ref now, 25 * 60 * Stopwatch.Frequency);
            idle.Send([0]);
        }

        Assert.Empty(await ReadAsync(idle, 1));
        active.Send(request);
        Assert.Equal(20, (await ReadAsync(active, 20)).Length);
    }

    [Fact]
    public async Task A_silent_client_is_closed_after_the_idle_time()
    {
        using Broadcaster broadcaster = CreateBroadcaster();
        using CommandServer server = Start(broadcaster, options => options.IdleTimeout = TimeSpan.FromSeconds(1));
        using Socket idle = Connect(server);
        Assert.Empty(await ReadAsync(idle, 1));
        await Limits.UntilAsync(() => server.ClientCount == 0);
    }
}
