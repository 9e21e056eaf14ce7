using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Delivery;

/// <summary>A server, a running reader, a window, and a delivery that was opened on the window's thread.</summary>
internal sealed class Scene : IAsyncDisposable
{
    private int _sent;

    private Scene(TestServer server, NeuronReader reader, MessageLoop window, FrameDelivery delivery)
    {
        Server = server;
        Reader = reader;
        Window = window;
        Delivery = delivery;
        Delivery.MotionReceived += frame => Seen.Add(frame.FrameIndex);
    }

    public TestServer Server { get; }

    public NeuronReader Reader { get; }

    public MessageLoop Window { get; }

    public FrameDelivery Delivery { get; }

    public TestConnection Connection { get; set; } = null!;

    /// <summary>The delivered frames. Read it while the window is idle.</summary>
    public List<uint?> Seen { get; } = [];

    public static async Task<Scene> StartAsync(FrameDeliveryOptions? options = null, bool reconnect = false, LatePost latePost = LatePost.Throw, FakeDeliveryClock? clock = null)
    {
        var server = new TestServer();
        var window = new MessageLoop(latePost);
        var reader = new NeuronReader(server.Options(reconnect));
        FrameDelivery delivery = window.Invoke(() => clock is null ? reader.OpenDelivery(options) : reader.OpenDeliveryWith(options, clock));
        var scene = new Scene(server, reader, window, delivery);
        reader.Start();
        scene.Connection = await server.AcceptAsync();
        return scene;
    }

    /// <summary>Sends frames and waits until they have arrived.</summary>
    public async Task SendAsync(int first, int count)
    {
        await Connection.SendAsync(TestPackets.Motions(first, count));
        _sent += count;
        await Reader.WaitForFramesAsync(_sent);
    }

    /// <summary>Keeps the window's thread busy until the result is disposed.</summary>
    public IDisposable BlockWindow()
    {
        var block = new Block();
        Window.Post(_ => block.Wait(), state: null);
        block.Entered.Wait(Limits.Unexpected, TestContext.Current.CancellationToken);
        return block;
    }

    public async ValueTask DisposeAsync()
    {
        await Reader.DisposeAsync();
        Connection.Dispose();
        Window.Dispose();
        Server.Dispose();
    }

    private sealed class Block : IDisposable
    {
        private readonly ManualResetEventSlim _released = new();

        public ManualResetEventSlim Entered { get; } = new();

        public void Wait()
        {
            Entered.Set();
            _released.Wait(Limits.Unexpected);
        }

        public void Dispose() => _released.Set();
    }
}
