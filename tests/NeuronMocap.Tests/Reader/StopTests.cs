using System.Net;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Reader;

// Dispose must end the reader in every state. Completion is set after the last thread of the reader has left its loop.
public sealed class StopTests
{
    [Fact]
    public async Task Before_the_start()
    {
        var reader = new NeuronReader("127.0.0.1");
        reader.Dispose();
        await AssertStoppedAsync(reader);
        Assert.Throws<ObjectDisposedException>(reader.Start);
        await Assert.ThrowsAsync<ObjectDisposedException>(() => reader.StartAsync());
    }

    [Fact]
    public async Task While_connecting_to_an_address_that_does_not_answer()
    {
        using var blackHole = new BlackHole();
        var reader = new NeuronReader("127.0.0.1", blackHole.Port);
        var log = new StatusLog(reader);
        reader.Start();
        await log.WaitAsync(ConnectionState.Connecting);
        reader.Dispose();
        await AssertStoppedAsync(reader);
    }

    [Fact]
    public async Task While_a_name_is_being_resolved()
    {
        var name = new UnansweredName();
        NeuronReader reader = name.CreateReader();
        reader.Start();
        await name.Asked.Soon();
        reader.Dispose();
        await AssertStoppedAsync(reader);
    }

    [Fact]
    public async Task While_waiting_for_the_next_attempt()
    {
        using var server = new TestServer();
        var reader = new NeuronReader(new NeuronReaderOptions
        {
            Port = server.Port,
            Reconnect = { InitialDelay = TimeSpan.FromHours(1), MaxDelay = TimeSpan.FromHours(1) },
        });
        var log = new StatusLog(reader);
        reader.Start();
        (await server.AcceptAsync()).Close();
        await log.WaitAsync(ConnectionState.Waiting);
        reader.Dispose();
        await AssertStoppedAsync(reader);
    }

    [Theory]
    [InlineData(0)]
    [InlineData(700)]
    [InlineData(1480)]
    [InlineData(2000)]
    public async Task While_connected_between_and_in_the_middle_of_frames(int bytes)
    {
        using var server = new TestServer();
        var reader = new NeuronReader(server.Options(reconnect: true));
        await reader.StartAsync().Soon();
        using TestConnection connection = await server.AcceptAsync();
        await connection.SendAsync(TestPackets.Motions(0, 2).AsMemory(0, bytes));
        reader.Dispose();
        await AssertStoppedAsync(reader);
    }

    [Fact]
    public async Task While_a_udp_port_waits_for_a_datagram()
    {
        var reader = new NeuronReader(new NeuronReaderOptions { Transport = TransportKind.Udp, LocalAddress = IPAddress.Loopback, Port = 0 });
        await reader.StartAsync().Soon();
        reader.Dispose();
        await AssertStoppedAsync(reader);
    }

    [Fact]
    public async Task From_a_handler_of_frames()
    {
        using var server = new TestServer();
        var reader = new NeuronReader(server.Options(reconnect: true));
        int frames = 0;
        reader.MotionReceived += _ =>
        {
            frames++;
            reader.Dispose();
        };
        reader.Start();
        using TestConnection connection = await server.AcceptAsync();
        await connection.SendAsync(TestPackets.Motions(0, 100));
        await AssertStoppedAsync(reader);
        Assert.Equal(1, frames);
    }

    [Theory]
    [InlineData(ConnectionState.Connecting)]
    [InlineData(ConnectionState.Connected)]
    [InlineData(ConnectionState.Receiving)]
    [InlineData(ConnectionState.Waiting)]
    public async Task From_a_handler_of_the_status(ConnectionState state)
    {
        using var server = new TestServer();
        var reader = new NeuronReader(server.Options(reconnect: true));
        reader.StatusChanged += status =>
        {
            if (status.State == state)
                reader.Dispose();
        };
        reader.Start();
        if (state != ConnectionState.Connecting)
        {
            using TestConnection connection = await server.AcceptAsync();
            if (state != ConnectionState.Connected)
            {
                await connection.SendAsync(TestPackets.Motion(1));
                connection.Close();
            }
        }

        await AssertStoppedAsync(reader);
    }

    [Fact]
    public async Task From_many_threads_at_once_and_while_a_queue_is_pumped()
    {
        using var server = new TestServer();
        for (int round = 0; round < 20; round++)
        {
            var reader = new NeuronReader(server.Options(reconnect: true));
            FrameQueue queue = reader.OpenQueue();
            reader.Start();
            using TestConnection connection = await server.AcceptAsync();
            await connection.SendAsync(TestPackets.Motions(0, 20));
            Task pumping = Task.Run(() =>
            {
                while (!reader.Completion.IsCompleted)
                    queue.Pump<MotionFrame>(_ => { });
            });
            await Task.WhenAll(Enumerable.Range(0, 4).Select(_ => Task.Run(reader.Dispose))).Soon();
            await AssertStoppedAsync(reader);
            await pumping.Soon();
            queue.Dispose();
            reader.Dispose();
        }
    }

    [Fact]
    public async Task At_any_moment_of_a_start()
    {
        using var server = new TestServer();
        using var accepting = new CancellationTokenSource();
        for (int round = 0; round < 200; round++)
        {
            var reader = new NeuronReader(server.Options(reconnect: true));
            Task starting = Task.Run(reader.Start);
            Thread.SpinWait(round * 50);
            await reader.DisposeAsync();
            await starting.ContinueWith(_ => { }, TaskScheduler.Default).Soon();
            await AssertStoppedAsync(reader);
        }
    }

    [Fact]
    public async Task A_stop_waits_for_a_busy_status_handler_and_none_follows()
    {
        using var server = new TestServer();
        NeuronReaderOptions options = server.Options(reconnect: true);
        options.SilenceTimeout = TimeSpan.FromMilliseconds(100);
        var reader = new NeuronReader(options);
        using var entered = new SemaphoreSlim(0);
        using var leave = new SemaphoreSlim(0);
        int handled = 0;
        reader.StatusChanged += status =>
        {
            if (status.State == ConnectionState.Silent)
            {
                entered.Release();
                leave.Wait(Limits.Unexpected);
            }

            Interlocked.Increment(ref handled);
        };
        reader.Start();
        using TestConnection connection = await server.AcceptAsync();
        Assert.True(await entered.WaitAsync(Limits.Unexpected));
        Task disposing = reader.DisposeAsync().AsTask();
        Assert.False(reader.Completion.IsCompleted);
        leave.Release();
        await reader.Completion.Soon();
        Assert.Equal(4, Volatile.Read(ref handled));
        await disposing.Soon();
    }

    [Fact]
    public async Task A_stop_waits_for_a_busy_handler()
    {
        using var server = new TestServer();
        var reader = new NeuronReader(server.Options());
        using var entered = new SemaphoreSlim(0);
        using var leave = new SemaphoreSlim(0);
        bool left = false;
        reader.MotionReceived += _ =>
        {
            entered.Release();
            leave.Wait(Limits.Unexpected);
            left = true;
        };
        reader.Start();
        using TestConnection connection = await server.AcceptAsync();
        await connection.SendAsync(TestPackets.Motion(1));
        Assert.True(await entered.WaitAsync(Limits.Unexpected));
        Task disposing = reader.DisposeAsync().AsTask();
        Assert.False(disposing.IsCompleted);
        leave.Release();
        await reader.Completion.Soon();
        Assert.True(left);
        await disposing.Soon();
    }

    [Fact]
    public async Task A_stuck_handler_of_the_end_is_abandoned()
    {
        using var server = new TestServer();
        NeuronReaderOptions options = server.Options(reconnect: true);
        options.Reconnect.InitialDelay = options.Reconnect.MaxDelay = TimeSpan.FromHours(1);
        options.StopTimeout = TimeSpan.FromMilliseconds(100);
        var reader = new NeuronReader(options);
        var log = new StatusLog(reader);
        using var leave = new SemaphoreSlim(0);
        reader.StatusChanged += status =>
        {
            if (status.State == ConnectionState.Stopped)
                leave.Wait(Limits.Unexpected);
        };
        reader.Start();
        (await server.AcceptAsync()).Close();
        await log.WaitAsync(ConnectionState.Waiting);
        await Task.Factory.StartNew(reader.Dispose, TaskCreationOptions.LongRunning).WaitAsync(Limits.Unexpected / 2);
        Assert.False(reader.Completion.IsCompleted);
        leave.Release();
        await AssertStoppedAsync(reader);
    }

    private static async Task AssertStoppedAsync(NeuronReader reader)
    {
        await reader.Completion.Soon();
        Assert.Equal((ConnectionState.Stopped, ConnectionReason.Requested), (reader.Status.State, reader.Status.Reason));
    }
}
