using System.Collections.Concurrent;
using System.Diagnostics;
using System.Net.Sockets;
using NeuronDataReaderWraper;
using NeuronMocap.Compatibility.Tests.Infrastructure;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Compatibility.Tests.Sockets;

public sealed class ConnectTests
{
    private static readonly TimeSpan Bound = Limits.Unexpected / 2;

    [Fact]
    public void A_connection_is_told_from_the_first_step_on()
    {
        using var server = new TestServer();
        using var log = new CallbackLog();

        IntPtr socket = log.Connect(server.Port);

        Assert.NotEqual(IntPtr.Zero, socket);
        Assert.Equal(SocketStatus.CS_Running, NeuronDataReader.BRGetSocketStatus(socket));
        Assert.Equal(
            [$"1 Connecting to 127.0.0.1:{server.Port} ...\n", $"0 Successfully connected to '127.0.0.1:{server.Port}'."],
            log.LinesOf(socket));
        Assert.All(log.Statuses, status => Assert.Equal(
            (CallbackLog.StatusObject, Environment.CurrentManagedThreadId), (status.CustomObject, status.Thread)));
    }

    [Fact]
    public void The_status_can_be_asked_for_while_it_is_told()
    {
        using var server = new TestServer();
        using var log = new CallbackLog();
        var asked = new List<SocketStatus>();
        log.OnStatus = status => asked.Add(NeuronDataReader.BRGetSocketStatus(status.Socket));

        NeuronDataReader.BRCloseSocket(log.Connect(server.Port));

        Assert.Equal([SocketStatus.CS_Starting, SocketStatus.CS_Running, SocketStatus.CS_OffWork], asked);
    }

    [Fact]
    public void A_refused_connection_is_zero_with_the_systems_number()
    {
        int port;
        using (var server = new TestServer())
            port = server.Port;

        using var log = new CallbackLog();
        var asked = new List<SocketStatus>();
        log.OnStatus = status => asked.Add(NeuronDataReader.BRGetSocketStatus(status.Socket));

        Assert.Equal(IntPtr.Zero, log.Connect(port));

        IntPtr socket = log.Statuses[0].Socket;
        Assert.NotEqual(IntPtr.Zero, socket);
        Assert.Equal(
            [$"1 Connecting to 127.0.0.1:{port} ...\n", $"1 Failed to connect to '127.0.0.1:{port}'.", "2 Service is stoped\n"],
            log.LinesOf(socket));
        Assert.Equal([SocketStatus.CS_Starting, SocketStatus.CS_Starting, SocketStatus.CS_OffWork], asked);
        int code = new SocketException((int)SocketError.ConnectionRefused).ErrorCode;
        Assert.Equal($"Failed to connect to '127.0.0.1:{port}'. System error code: {code}", NeuronDataReader.strBRGetLastErrorMessage());
        if (OperatingSystem.IsLinux())
            Assert.Equal(111, code);
    }

    // The vendor's library ends the process for a name that it cannot find.
    [Theory]
    [InlineData("no-such-computer.invalid", 7001, 11001)]
    [InlineData("", 7001, null)]
    [InlineData("127.0.0.1", 0, null)]
    [InlineData("127.0.0.1", 65_536, null)]
    [InlineData("127.0.0.1", -1, null)]
    [InlineData(null, 7001, null)]
    public void What_no_computer_can_be_is_a_failure_and_no_crash(string? host, int port, int? code)
    {
        using var log = new CallbackLog();
        long start = Stopwatch.GetTimestamp();

        Assert.Equal(IntPtr.Zero, log.Connect(port, host!));

        Assert.True(Stopwatch.GetElapsedTime(start) < Bound);
        code ??= new SocketException((int)SocketError.InvalidArgument).ErrorCode;
        Assert.Equal($"Failed to connect to '{host}:{port}'. System error code: {code}", NeuronDataReader.strBRGetLastErrorMessage());
        Assert.Equal(3, log.Statuses.Count);
    }

    [Fact]
    public void A_server_that_does_not_answer_is_given_up()
    {
        using var hole = new BlackHole();
        using var log = new CallbackLog();
        long start = Stopwatch.GetTimestamp();

        Assert.Equal(IntPtr.Zero, log.Connect(hole.Port));

        Assert.True(Stopwatch.GetElapsedTime(start) < Bound);
        int code = new SocketException((int)SocketError.TimedOut).ErrorCode;
        Assert.Equal($"Failed to connect to '127.0.0.1:{hole.Port}'. System error code: {code}", NeuronDataReader.strBRGetLastErrorMessage());
    }

    // Programs of that time stop their threads so. Whoever asks for the same place afterwards must not wait for a thread that is gone.
    [Fact]
    public void A_thread_that_is_interrupted_while_it_connects_leaves_nothing_behind()
    {
        using var hole = new BlackHole();
        using var log = new CallbackLog();
        log.OnStatus = static _ => Thread.CurrentThread.Interrupt();

        Assert.Throws<ThreadInterruptedException>(() => log.Connect(hole.Port));

        log.OnStatus = null;
        Assert.Equal(SocketStatus.CS_OffWork, NeuronDataReader.BRGetSocketStatus(log.Statuses[0].Socket));
        IntPtr again = new(-1);
        var thread = new Thread(() => again = log.Connect(hole.Port)) { IsBackground = true };
        thread.Start();
        Assert.True(thread.Join(Limits.Unexpected));
        Assert.Equal(IntPtr.Zero, again);
    }

    [Fact]
    public async Task A_second_call_for_the_same_place_gives_the_same_connection()
    {
        using var log = new CallbackLog();
        using PacketServer server = await PacketServer.ConnectAsync(log);
        int statuses = log.Statuses.Count;

        Assert.Equal(server.Socket, log.Connect(server.Port));

        Assert.Equal(statuses, log.Statuses.Count);
        await server.SendAsync(TestPackets.Motion(1));
        await log.FramesAsync(1);
        Assert.Single(log.Frames);
    }

    [Fact]
    public async Task Threads_that_ask_for_the_same_place_at_once_get_one_connection()
    {
        using var server = new TestServer();
        using var log = new CallbackLog();
        using var barrier = new Barrier(4);

        IntPtr[] sockets = await Task.WhenAll(Enumerable.Range(0, 4).Select(_ => Task.Factory.StartNew(
            () =>
            {
                barrier.SignalAndWait();
                return NeuronDataReader.BRConnectTo("127.0.0.1", server.Port);
            },
            CancellationToken.None,
            TaskCreationOptions.LongRunning,
            TaskScheduler.Default))).Soon();

        IntPtr socket = Assert.Single(sockets.Distinct());
        Assert.NotEqual(IntPtr.Zero, socket);
        Assert.Equal(2, log.Statuses.Count);
        NeuronDataReader.BRCloseSocket(socket);
    }

    // None may wait for the other, whose callback waits for it.
    [Fact]
    public async Task Threads_whose_callbacks_ask_for_each_others_connection_get_it()
    {
        using var first = new TestServer();
        using var second = new TestServer();
        using var log = new CallbackLog();
        using var barrier = new Barrier(2);
        var asked = new ConcurrentDictionary<IntPtr, IntPtr>();
        log.OnStatus = status =>
        {
            if (status.Status != SocketStatus.CS_Starting)
                return;

            barrier.SignalAndWait(Limits.Unexpected);
            bool isFirst = status.Text.Contains($":{first.Port} ", StringComparison.Ordinal);
            asked[status.Socket] = NeuronDataReader.BRConnectTo("127.0.0.1", isFirst ? second.Port : first.Port);
        };

        IntPtr[] sockets = await Task.WhenAll(((TestServer[])[first, second]).Select(static server => Task.Factory.StartNew(
            () => NeuronDataReader.BRConnectTo("127.0.0.1", server.Port),
            CancellationToken.None,
            TaskCreationOptions.LongRunning,
            TaskScheduler.Default))).Soon();

        Assert.DoesNotContain(IntPtr.Zero, sockets);
        Assert.Equal((sockets[1], sockets[0]), (asked[sockets[0]], asked[sockets[1]]));
        Assert.Equal(4, log.Statuses.Count);
        Array.ForEach(sockets, NeuronDataReader.BRCloseSocket);
    }

    [Fact]
    public void Handles_are_never_used_again()
    {
        using var server = new TestServer();
        using var log = new CallbackLog();
        var seen = new HashSet<IntPtr>();
        for (int i = 0; i < 20; i++)
        {
            IntPtr socket = log.Connect(server.Port);
            Assert.True(seen.Add(socket));
            NeuronDataReader.BRCloseSocket(socket);
        }

        Assert.All(seen, static socket => Assert.Equal(SocketStatus.CS_OffWork, NeuronDataReader.BRGetSocketStatus(socket)));
    }

    [Fact]
    public async Task Frames_of_two_connections_tell_theirs()
    {
        using var log = new CallbackLog();
        using PacketServer first = await PacketServer.ConnectAsync(log);
        using PacketServer second = await PacketServer.ConnectAsync(log);
        Assert.NotEqual(first.Socket, second.Socket);

        await first.SendAsync(TestPackets.Motion(1));
        await second.SendAsync(TestPackets.Motion(2));
        await log.FramesAsync(2);

        Assert.Equal(first.Socket, log.Frames.Single(static frame => frame.Motion.FrameIndex == 1).Socket);
        Assert.Equal(second.Socket, log.Frames.Single(static frame => frame.Motion.FrameIndex == 2).Socket);
        NeuronDataReader.BRCloseSocket(first.Socket);
        await second.SendAsync(TestPackets.Motion(3));
        await log.FramesAsync(3);
    }

    // The server sends as soon as it accepts; the frames wait.
    [Fact]
    public async Task No_frame_comes_before_the_connection_was_told()
    {
        using var server = new TestServer();
        using var log = new CallbackLog();
        for (int i = 0; i < 10; i++)
        {
            Task<TestConnection> accepting = Task.Run(async () =>
            {
                TestConnection connection = await server.AcceptAsync();
                await connection.SendAsync(TestPackets.Motion(i));
                return connection;
            });
            int frames = log.Frames.Count;
            log.OnStatus = status =>
            {
                if (status.Status == SocketStatus.CS_Running)
                    accepting.Wait(Limits.Unexpected);
            };
            IntPtr socket = log.Connect(server.Port);
            await log.FramesAsync(frames + 1);
            Assert.All(log.Statuses.Where(status => status.Socket == socket), status => Assert.Equal(frames, status.FramesBefore));
            log.OnStatus = null;
            NeuronDataReader.BRCloseSocket(socket);
            (await accepting).Dispose();
        }
    }
}
