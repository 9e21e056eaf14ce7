using System.Collections.Concurrent;
using NeuronMocap.Compatibility.Callbacks;
using NeuronMocap.Compatibility.Sockets;
using NeuronMocap.Compatibility.Tests.Infrastructure;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Compatibility.Tests.Sockets;

// How long closing waits, and that no callback starts after it returns.
public sealed class ClosingTests
{
    // The vendor's libraries take 50 to 100 ms to close.
    [Fact]
    public void Closing_waits_50_to_100_ms_for_a_callback() =>
        Assert.InRange(VendorSocket.CloseTimeout, TimeSpan.FromMilliseconds(50), TimeSpan.FromMilliseconds(100));

    // The system may suspend the receive thread at any point and for any time.
    [Fact]
    public async Task A_delayed_receive_thread_calls_no_callback_after_closing()
    {
        using var server = new TestServer();
        using var callbacks = new HeldUpCallbacks();
        var functions = new VendorFunctions(callbacks);
        IntPtr socket = functions.Connect("127.0.0.1", server.Port);
        using TestConnection connection = await server.AcceptAsync();
        await connection.SendAsync(TestPackets.Motions(0, 10));
        await Limits.UntilAsync(() => callbacks.IsHeldUp);

        VendorFunctions.Close(socket);
        callbacks.Continue();
        await Limits.UntilAsync(() => connection.Socket.HasEnded());

        Assert.Equal(0, callbacks.Frames);
        Assert.Equal("Service is stoped\n", callbacks.Statuses.Last());
    }

    [Fact]
    public async Task Callbacks_may_be_replaced_while_connections_are_closed()
    {
        using var log = new CallbackLog();
        using PacketServer server = await PacketServer.ConnectAsync(log);
        using var stop = new CancellationTokenSource();
        int wrong = 0, frames = 0, replacements = 0;
        Task replacing = Task.Factory.StartNew(Replace, CancellationToken.None, TaskCreationOptions.LongRunning, TaskScheduler.Default);
        try
        {
            // Frames that come before are not counted.
            await Limits.UntilAsync(() => Volatile.Read(ref replacements) > 0);
            for (int i = 0; i < 20; i++)
            {
                int before = Volatile.Read(ref frames);
                await server.SendAsync(TestPackets.Motions(0, 30));
                await Limits.UntilAsync(() => Volatile.Read(ref frames) > before);
                NeuronDataReaderWraper.NeuronDataReader.BRCloseSocket(server.Socket);
                server.Connection.Dispose();
                await server.ReconnectAsync(log);
            }
        }
        finally
        {
            // Otherwise a failure here would replace the callbacks of all later tests.
            await stop.CancelAsync();
            await replacing.Soon();
        }

        Assert.Equal(0, wrong);
        Assert.Empty(log.Failures);

        // Each callback has its own object.
        void Replace()
        {
            for (int i = 1; !stop.IsCancellationRequested; i++)
            {
                IntPtr mine = i;
                NeuronDataReaderWraper.NeuronDataReader.BRRegisterFrameDataCallback(mine, (customObject, _, _, _) =>
                {
                    Interlocked.Increment(ref frames);
                    if (customObject != mine)
                        Interlocked.Increment(ref wrong);
                });
                Volatile.Write(ref replacements, i);

                // Locks are not fair: without this, a busy computer may keep the receive thread out.
                Thread.Yield();
            }
        }
    }

    // Blocks the receive thread where it asks whether a frame is wanted.
    private sealed class HeldUpCallbacks : IVendorCallbacks, IDisposable
    {
        private readonly ManualResetEventSlim _continue = new();
        private int _frames;

        public bool IsHeldUp { get; private set; }

        public int Frames => Volatile.Read(ref _frames);

        public ConcurrentQueue<string> Statuses { get; } = new();

        public HeaderLayout FrameHeaders => HeaderLayout.New;

        public bool WantsFrames
        {
            get
            {
                IsHeldUp = true;
                return _continue.Wait(Limits.Unexpected);
            }
        }

        public bool WantsCalculation => true;

        public bool WantsCommands => true;

        public void Continue() => _continue.Set();

        public void OnFrame(IntPtr socket, IntPtr header, IntPtr data) => Interlocked.Increment(ref _frames);

        public void OnCalculation(IntPtr socket, IntPtr header, IntPtr data)
        {
        }

        public void OnStatus(IntPtr socket, SocketState status, string message) => Statuses.Enqueue(message);

        public void OnCommand(IntPtr socket, IntPtr header, IntPtr data)
        {
        }

        public void Dispose() => _continue.Dispose();
    }
}
