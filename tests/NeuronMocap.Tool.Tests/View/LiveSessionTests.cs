using System.Diagnostics;
using NeuronMocap.Server;
using NeuronMocap.Tool.Arguments;
using NeuronMocap.Tool.View;
using NeuronMocap.Tool.View.Control;
using NeuronMocap.Tool.View.Live;

namespace NeuronMocap.Tool.Tests.View;

// The work of the server depends on who listens.
public sealed class LiveSessionTests
{
    [Fact]
    public async Task Nothing_is_done_for_pages_that_do_not_listen()
    {
        await using Broadcaster broadcaster = Broadcaster.StartDemo();
        await using var reader = new NeuronReader("127.0.0.1", broadcaster.LocalEndPoint!.Port);
        LiveSession? live = null;
        await using var hub = new ControlHub(() => [.. live!.Greet()]);
        await using (live = new LiveSession(reader, "demo", hub))
        {
            var options = new ViewOptions(Source.Demo, new ConnectionOptions()) { Port = 0 };
            await using ViewServer server = await ViewServer.StartAsync(options, [hub, live]);
            reader.Start();
            await PassFramesAsync(reader);
            Assert.Equal((0, 0), (live.Poses.Encoded, live.Motion.FramesTaken));

            // A page shows the motion.
            using (ViewSocket control = await ConnectAsync(server, "/control"))
            using (ViewSocket motion = await ConnectAsync(server, "/motion"))
            {
                await control.FindAsync("status");
                Assert.NotNull(await motion.ReceiveAsync());
                Assert.True(live.Poses.Encoded > 0);
                await Limits.UntilAsync(() => live.Motion.FramesTaken > 0);
                await control.CloseAsync();
                await motion.CloseAsync();
            }

            // Its tab is hidden. A frame on its way may still be counted, but then no more.
            await Limits.UntilAsync(() => hub.Clients == 0 && live.MotionClients == 0);
            (long, long) before, after = (-1, -1);
            var patience = Stopwatch.StartNew();
            do
            {
                Assert.True(patience.Elapsed < Limits.Unexpected, "The server encodes frames that nobody sees.");
                before = after;
                await PassFramesAsync(reader);
                after = (live.Poses.Encoded, live.Motion.FramesTaken);
            }
            while (after != before);

            // It is shown again.
            using ViewSocket again = await ConnectAsync(server, "/motion");
            Assert.NotNull(await again.ReceiveAsync());
        }
    }

    [Fact]
    public async Task Handlers_of_motion_come_and_go_while_frames_arrive()
    {
        await using Broadcaster broadcaster = Broadcaster.StartDemo(frameRate: 500);
        await using var reader = new NeuronReader("127.0.0.1", broadcaster.LocalEndPoint!.Port);
        using var motion = new LiveMotion(reader);
        reader.Start();
        int running = 0;
        for (int i = 0; i < 20; i++)
        {
            int calls = 0;
            IDisposable subscription = motion.Subscribe(_ =>
            {
                Assert.Equal(1, Interlocked.Increment(ref running));
                Interlocked.Increment(ref calls);
                Interlocked.Decrement(ref running);
            });
            await Limits.UntilAsync(() => Volatile.Read(ref calls) > 2);
            subscription.Dispose();
            subscription.Dispose();
        }
    }

    private static Task<ViewSocket> ConnectAsync(ViewServer server, string path) =>
        ViewSocket.ConnectAsync(new Uri($"ws://{server.LocalEndPoint}{path}"), path == "/motion" ? "pose" : null, configure: null);

    private static async Task PassFramesAsync(NeuronReader reader, int count = 10)
    {
        long before = reader.GetStatistics().MotionFrames;
        await Limits.UntilAsync(() => reader.GetStatistics().MotionFrames >= before + count);
    }
}
