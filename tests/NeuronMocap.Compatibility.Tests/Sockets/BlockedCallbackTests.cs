using System.Diagnostics;
using System.Net;
using System.Net.Sockets;
using System.Runtime.InteropServices;
using NeuronDataReaderWraper;
using NeuronMocap.Compatibility.Tests.Infrastructure;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Compatibility.Tests.Sockets;

// Closes while a callback waits, as in every program whose callback asks the thread of its user interface to do something.
public sealed class BlockedCallbackTests : IDisposable
{
    private const int Rounds = 5;

    // A callback that waits for the closing thread would have blocked it for 2 s.
    private static readonly TimeSpan LetGo = TimeSpan.FromSeconds(1);

    private readonly ManualResetEventSlim _release = new();
    private int _ended;

    public void Dispose()
    {
        _release.Set();
        _release.Dispose();
    }

    [Fact]
    public async Task Closing_releases_a_waiting_callback_and_starts_no_other()
    {
        using var log = new CallbackLog();
        using PacketServer server = await PacketServer.ConnectAsync(log);
        log.OnFrame = Block;
        TimeSpan quickest = TimeSpan.MaxValue;
        for (int i = 1; i <= Rounds; i++)
        {
            await server.SendAsync(TestPackets.Motions(0, 50));
            await log.FramesAsync(i);
            long start = Stopwatch.GetTimestamp();

            NeuronDataReader.BRCloseSocket(server.Socket);

            quickest = Min(quickest, Stopwatch.GetElapsedTime(start));
            Assert.Equal(i - 1, Volatile.Read(ref _ended));
            Assert.Equal("2 Service is stoped\n", log.LinesOf(server.Socket).Last());
            _release.Set();
            await Limits.UntilAsync(() => Volatile.Read(ref _ended) == i && server.Connection.Socket.HasEnded());
            Assert.Equal(i, log.Frames.Count);
            _release.Reset();
            await server.ReconnectAsync(log);
        }

        Assert.True(quickest < LetGo, $"{quickest}");
    }

    [Fact]
    public async Task Closing_releases_the_callback_of_a_UDP_service()
    {
        int port = FreePort.Next();
        using var log = new CallbackLog();
        log.OnFrame = Block;
        IntPtr service = log.Listen(port);
        using var sender = new UdpClient();
        for (int i = 0; i < 20; i++)
            sender.Send(TestPackets.Motion(i), new IPEndPoint(IPAddress.Loopback, port));
        await log.FramesAsync(1);

        NeuronDataReader.BRCloseSocket(service);

        Assert.Equal(0, Volatile.Read(ref _ended));
        _release.Set();
        await Limits.UntilAsync(() => Volatile.Read(ref _ended) == 1);

        // Uses the same port, which is free only after the previous listener has ended.
        IntPtr again = log.Listen(port);
        Assert.NotEqual(IntPtr.Zero, again);
        Assert.Single(log.Frames);
    }

    [Fact]
    public async Task Each_of_several_connections_is_closed_without_waiting_for_the_others()
    {
        const int count = 4;
        using var log = new CallbackLog();
        log.OnFrame = Block;
        var servers = new List<PacketServer>();
        try
        {
            for (int i = 0; i < count; i++)
            {
                servers.Add(await PacketServer.ConnectAsync(log));
                await servers[i].SendAsync(TestPackets.Motion(1), TestPackets.Motion(2));
                await log.FramesAsync(i + 1);
            }

            foreach (PacketServer server in servers)
                NeuronDataReader.BRCloseSocket(server.Socket);

            Assert.Equal(0, Volatile.Read(ref _ended));
            _release.Set();
            await Limits.UntilAsync(() => Volatile.Read(ref _ended) == count && servers.TrueForAll(static server => server.Connection.Socket.HasEnded()));
            Assert.Equal(count, log.Frames.Count);
        }
        finally
        {
            servers.ForEach(static server => server.Dispose());
        }
    }

    // Like a program that shows the status in its window.
    [Fact]
    public async Task Closing_releases_a_waiting_status_callback()
    {
        using var log = new CallbackLog();
        using PacketServer server = await PacketServer.ConnectAsync(log);
        log.OnStatus = status =>
        {
            if (status.Text.StartsWith("Failed", StringComparison.Ordinal))
                Block(status.Socket);
        };
        server.Connection.Close();
        await Limits.UntilAsync(() => log.Statuses.Count == 3);

        NeuronDataReader.BRCloseSocket(server.Socket);

        Assert.Equal(0, Volatile.Read(ref _ended));
        Assert.Equal("2 Service is stoped\n", log.LinesOf(server.Socket).Last());
        int told = log.Statuses.Count;
        _release.Set();
        await Limits.UntilAsync(() => Volatile.Read(ref _ended) == 1);
        await server.ReconnectAsync(log);
        Assert.Equal(told, log.Statuses.Count - 2);
    }

    [Theory]
    [InlineData("Connecting")]
    [InlineData("Successfully")]
    public async Task Closing_releases_the_status_callback_of_a_pending_connection(string text)
    {
        using var server = new TestServer();
        using var log = new CallbackLog();
        log.OnStatus = status =>
        {
            if (status.Text.StartsWith(text, StringComparison.Ordinal))
                Block(status.Socket);
        };
        Task<IntPtr> connecting = Task.Factory.StartNew(
            () => log.Connect(server.Port), TestContext.Current.CancellationToken, TaskCreationOptions.LongRunning, TaskScheduler.Default);
        await Limits.UntilAsync(() => log.Statuses.Any(status => status.Text.StartsWith(text, StringComparison.Ordinal)));

        NeuronDataReader.BRCloseSocket(log.Statuses[0].Socket);

        Assert.Equal(0, Volatile.Read(ref _ended));
        int told = log.Statuses.Count;
        _release.Set();
        Assert.Equal(IntPtr.Zero, await connecting.Soon());
        Assert.Equal(told, log.Statuses.Count);
    }

    [Fact]
    public async Task Closing_from_two_threads_reports_the_end_once_before_either_returns()
    {
        // On a busy computer, the reporting thread may be late in some rounds.
        int fewest = 0;
        using var log = new CallbackLog();
        using PacketServer server = await PacketServer.ConnectAsync(log);
        log.OnFrame = Block;
        for (int i = 1; i <= Rounds; i++)
        {
            await server.SendAsync(TestPackets.Motion(1), TestPackets.Motion(2));
            await log.FramesAsync(i);
            using var start = new Barrier(2);
            Task<int>[] closing = [CloseAsync(), CloseAsync()];
            int[] told = await Task.WhenAll(closing).Soon();

            fewest = Math.Max(fewest, told.Min());
            Assert.Single(log.LinesOf(server.Socket), IsEnd);
            Assert.Equal(i - 1, Volatile.Read(ref _ended));
            _release.Set();
            await Limits.UntilAsync(() => Volatile.Read(ref _ended) == i && server.Connection.Socket.HasEnded());
            Assert.Equal(i, log.Frames.Count);
            _release.Reset();
            await server.ReconnectAsync(log);

            // Returns how often the end was reported by the time closing returned.
            Task<int> CloseAsync() => Task.Factory.StartNew(
                () =>
                {
                    start.SignalAndWait();
                    NeuronDataReader.BRCloseSocket(server.Socket);
                    return log.LinesOf(server.Socket).Count(IsEnd);
                },
                CancellationToken.None,
                TaskCreationOptions.LongRunning,
                TaskScheduler.Default);
        }

        Assert.Equal(1, fewest);

        static bool IsEnd(string line) => line == "2 Service is stoped\n";
    }

    // Another thread closes while this callback runs, and then the callback closes too.
    [Fact]
    public async Task A_waited_for_callback_may_close_again()
    {
        using var log = new CallbackLog();
        using PacketServer server = await PacketServer.ConnectAsync(log);
        log.OnFrame = socket =>
        {
            _release.Wait(Limits.Unexpected);
            NeuronDataReader.BRCloseSocket(socket);
            Interlocked.Increment(ref _ended);
        };
        await server.SendAsync(TestPackets.Motions(0, 20));
        await log.FramesAsync(1);
        Task closing = Task.Factory.StartNew(
            () => NeuronDataReader.BRCloseSocket(server.Socket), CancellationToken.None, TaskCreationOptions.LongRunning, TaskScheduler.Default);

        _release.Set();
        await closing.Soon();
        await Limits.UntilAsync(() => Volatile.Read(ref _ended) == 1);

        Assert.Single(log.LinesOf(server.Socket), static line => line == "2 Service is stoped\n");
        Assert.Single(log.Frames);
    }

    // Handlers of the event may wait for the same thread.
    [Fact]
    public async Task Closing_releases_a_handler_of_callback_exceptions()
    {
        using var log = new CallbackLog();
        using PacketServer server = await PacketServer.ConnectAsync(log);
        log.OnFrame = static _ => throw new InvalidOperationException("As meant.");
        CompatibilityEvents.CallbackFailed += OnFailed;
        try
        {
            await server.SendAsync(TestPackets.Motion(1), TestPackets.Motion(2));
            await Limits.UntilAsync(() => log.Failures.Count == 1);

            NeuronDataReader.BRCloseSocket(server.Socket);

            Assert.Equal(0, Volatile.Read(ref _ended));
            _release.Set();
            await Limits.UntilAsync(() => Volatile.Read(ref _ended) == 1);
            Assert.Single(log.Frames);
        }
        finally
        {
            CompatibilityEvents.CallbackFailed -= OnFailed;
        }

        void OnFailed(Exception exception) => Block(IntPtr.Zero);
    }

    // The data passed to a callback stays valid until the callback ends, however late that is and whatever else comes and goes.
    [Fact]
    public async Task A_callback_that_ends_after_closing_still_reads_its_frame()
    {
        byte[] packet = TestPackets.Motion(7);
        byte[]? late = null;
        using var log = new CallbackLog();
        using PacketServer server = await PacketServer.ConnectAsync(log);
        int calls = 0;
        NeuronDataReader.BRRegisterFrameDataCallback(IntPtr.Zero, (_, _, header, data) =>
        {
            if (Interlocked.Increment(ref calls) > 1)
                return;

            _release.Wait(Limits.Unexpected);
            byte[] read = new byte[packet.Length];
            Marshal.Copy(header, read, 0, 64);
            Marshal.Copy(data, read, 64, packet.Length - 64);
            late = read;
        });
        await server.SendAsync(packet);
        await Limits.UntilAsync(() => Volatile.Read(ref calls) == 1);

        NeuronDataReader.BRCloseSocket(server.Socket);
        for (int i = 0; i < Rounds; i++)
        {
            using PacketServer other = await PacketServer.ConnectAsync(log);
            await other.SendAsync(TestPackets.Motion(8));
            await Limits.UntilAsync(() => Volatile.Read(ref calls) == i + 2);
            NeuronDataReader.BRCloseSocket(other.Socket);
            GC.Collect();
            GC.WaitForPendingFinalizers();
        }

        _release.Set();
        await Limits.UntilAsync(() => late is not null);
        Assert.Equal(packet, late);
    }

    private static TimeSpan Min(TimeSpan left, TimeSpan right) => left < right ? left : right;

    private void Block(IntPtr socket)
    {
        _release.Wait(Limits.Unexpected);
        Interlocked.Increment(ref _ended);
    }
}
