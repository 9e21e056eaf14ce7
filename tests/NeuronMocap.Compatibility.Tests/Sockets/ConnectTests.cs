using System.Collections.Concurrent;
using NeuronDataReaderWraper;
using NeuronMocap.Compatibility.Tests.Infrastructure;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Compatibility.Tests.Sockets;

// In addition to the contract: interrupted threads, and callbacks that wait for each other.
public sealed class ConnectTests
{
    // Programs of that time interrupt their threads to stop them. A later connection to the same address must not wait for a thread that is gone.
    [Fact]
    public void Interrupting_a_connecting_thread_leaves_nothing()
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
    public async Task Concurrent_connects_to_one_address_share_a_connection()
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

    // Neither may wait for the other, because the other's callback waits for it.
    [Fact]
    public async Task Callbacks_can_ask_for_each_others_connection()
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
    public async Task Frames_name_their_connection()
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
}
