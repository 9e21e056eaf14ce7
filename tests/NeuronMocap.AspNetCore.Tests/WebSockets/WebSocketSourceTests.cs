using Microsoft.AspNetCore.Builder;
using NeuronMocap.AspNetCore.Tests.Infrastructure;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.AspNetCore.Tests.WebSockets;

// A reader that receives over a WebSocket.
public sealed class WebSocketSourceTests
{
    [Theory]
    [InlineData(ReceiveThread.Auto, ReceiveThread.Pool)]
    [InlineData(ReceiveThread.Dedicated, ReceiveThread.Dedicated)]
    public async Task A_reader_gets_whole_packets(ReceiveThread wanted, ReceiveThread used)
    {
        await using MotionSite site = await MotionSite.StartAsync(new WebSocketBroadcasterOptions { Token = "word" });
        await using var reader = new NeuronReader(Options(Source(site.Address, "word"), wanted));
        var packets = new List<byte[]>();
        reader.MotionReceived += frame => packets.Add(frame.Packet.ToArray());
        reader.Start();
        await Limits.UntilAsync(() => site.Broadcaster.GetStatistics().Clients == 1);
        for (int frame = 1; frame <= 20; frame++)
        {
            await site.Motion.SendAsync(TestPackets.Motion(frame));
            await reader.WaitForFramesAsync(frame);
        }

        Assert.Equal(TestPackets.Motions(1, 20), packets.SelectMany(static packet => packet));
        Assert.Equal((ConnectionState.Receiving, used), (reader.Status.State, reader.Status.ReceiveThread));
        Assert.Equal(site.Address, reader.Name);

        // The stream of the server ends, and so does this one.
        await site.Reader.DisposeAsync();
        await reader.Completion.Soon();
        Assert.Equal((ConnectionState.Stopped, ConnectionReason.ClosedByPeer), (reader.Status.State, reader.Status.Reason));
        await Limits.UntilAsync(() => site.Broadcaster.GetStatistics().Clients == 0);
    }

    // The system lists a connection with the timer that runs for it: 02 is that of keep-alive.
    [Fact]
    public async Task A_dead_server_is_noticed_by_probes()
    {
        Assert.SkipUnless(File.Exists("/proc/net/tcp"), "This system does not list its connections in a file.");
        await using MotionSite site = await MotionSite.StartAsync();
        var address = new Uri(site.Address);
        await using var reader = new NeuronReader(Options(Source(site.Address)));
        await reader.StartAsync(TestContext.Current.CancellationToken).Soon();
        string server = $"0100007F:{address.Port:X4}";
        await Limits.UntilAsync(() => ((string[])["/proc/net/tcp", "/proc/net/tcp6"]).Where(File.Exists).SelectMany(File.ReadAllLines)
            .Select(static line => line.Split(' ', StringSplitOptions.RemoveEmptyEntries))
            .Any(words => words[2].EndsWith(server, StringComparison.Ordinal) && words[5].StartsWith("02:", StringComparison.Ordinal)));
    }

    [Fact]
    public void A_timeout_that_cannot_work_is_refused()
    {
        foreach (TimeSpan timeout in (TimeSpan[])[TimeSpan.Zero, TimeSpan.FromSeconds(-5), TimeSpan.MaxValue, Timeout.InfiniteTimeSpan])
            Assert.Throws<ArgumentOutOfRangeException>(() => new WebSocketSource(new Uri("ws://127.0.0.1:1")) { ConnectTimeout = timeout });
    }

    [Fact]
    public async Task A_stop_ends_a_pending_read()
    {
        await using MotionSite site = await MotionSite.StartAsync();
        foreach (ReceiveThread thread in (ReceiveThread[])[ReceiveThread.Pool, ReceiveThread.Dedicated])
        {
            await using var reader = new NeuronReader(Options(Source(site.Address), thread));
            await reader.StartAsync(TestContext.Current.CancellationToken).Soon();
            await reader.DisposeAsync().AsTask().Soon();
            Assert.Equal(ConnectionState.Stopped, reader.Status.State);
        }

        await Limits.UntilAsync(() => site.Broadcaster.GetStatistics() is { Clients: 0, Accepted: 2 });
    }

    [Theory]
    [InlineData("", null, ConnectionReason.AccessDenied, "The server wants a token.")]
    [InlineData("", "other", ConnectionReason.AccessDenied, "The token is wrong.")]
    [InlineData("?rate=99999", "word", ConnectionReason.Refused, "The server does not accept the request; check the query, such as rate.")]
    [InlineData("x", "word", ConnectionReason.Refused, "There is no motion at this path. Check the address.")]
    public async Task A_refusal_says_why(string path, string? token, ConnectionReason reason, string why)
    {
        await using MotionSite site = await MotionSite.StartAsync(new WebSocketBroadcasterOptions { Token = "word" });
        await using var reader = new NeuronReader(Options(Source($"{site.Address}{path}", token)));
        NeuronConnectionException exception = await Assert.ThrowsAsync<NeuronConnectionException>(() => reader.StartAsync(TestContext.Current.CancellationToken).Soon());
        Assert.Equal((reason, $"Opening {site.Address}{path.Split('?')[0]} failed: {why}"), (exception.Reason, exception.Message));
    }

    [Fact]
    public async Task A_server_that_is_not_there_or_not_one_is_named()
    {
        int port = FreePort.Next();
        await using var nobody = new NeuronReader(Options(Source($"ws://127.0.0.1:{port}")));
        NeuronConnectionException exception = await Assert.ThrowsAsync<NeuronConnectionException>(() => nobody.StartAsync(TestContext.Current.CancellationToken).Soon());
        Assert.Equal((ConnectionReason.Refused, $"Opening ws://127.0.0.1:{port} failed: Nothing listens on this port."), (exception.Reason, exception.Message));

        using var motion = new TestServer();
        await using var plain = new NeuronReader(Options(Source($"ws://127.0.0.1:{motion.Port}")));
        Task<NeuronConnectionException> failing = Assert.ThrowsAsync<NeuronConnectionException>(() => plain.StartAsync(TestContext.Current.CancellationToken).Soon());
        using (TestConnection connection = await motion.AcceptAsync())
            await connection.SendAsync(TestPackets.Motions(1, 3));

        exception = await failing;
        Assert.Equal($"Opening ws://127.0.0.1:{motion.Port} failed: There is no web server on this port.", exception.Message);

        await using WebServer web = await WebServer.StartAsync(map: static application => application.MapGet("/", static () => "Hello"));
        await using var other = new NeuronReader(Options(Source($"ws://127.0.0.1:{web.Port}")));
        exception = await Assert.ThrowsAsync<NeuronConnectionException>(() => other.StartAsync(TestContext.Current.CancellationToken).Soon());
        Assert.Contains("The server answers with status 200. It may not be a server of motion.", exception.Message, StringComparison.Ordinal);

        using var silent = new TestServer();
        await using var waiting = new NeuronReader(Options(new WebSocketSource(new Uri($"ws://127.0.0.1:{silent.Port}")) { ConnectTimeout = TimeSpan.FromSeconds(0.2) }));
        exception = await Assert.ThrowsAsync<NeuronConnectionException>(() => waiting.StartAsync(TestContext.Current.CancellationToken).Soon());
        Assert.Equal(ConnectionReason.TimedOut, exception.Reason);
        Assert.Contains("The server did not answer within 0.2 s.", exception.Message, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_reader_connects_again_when_the_server_is_back()
    {
        using var server = new TestServer();
        await using var source = new NeuronReader(server.Options());
        source.Start();
        using TestConnection motion = await server.AcceptAsync();
        await using var broadcaster = new WebSocketBroadcaster(source);
        int port = FreePort.Next();
        NeuronReaderOptions options = Options(Source($"ws://127.0.0.1:{port}/motion"));
        options.Reconnect = new ReconnectPolicy { InitialDelay = TimeSpan.FromMilliseconds(1), MaxDelay = TimeSpan.FromMilliseconds(5) };
        await using var reader = new NeuronReader(options);
        reader.Start();
        for (int run = 1; run <= 2; run++)
        {
            await Limits.UntilAsync(() => reader.Status.Reason == ConnectionReason.Refused);
            await using WebServer web = await WebServer.StartAsync(map: application => application.MapNeuronWebSocket("/motion", broadcaster), port: port);
            await Limits.UntilAsync(() => broadcaster.GetStatistics().Clients == 1);
            await motion.SendAsync(TestPackets.Motion(run));
            await reader.WaitForFramesAsync(run);
            await web.StopAsync();
        }

        Assert.Equal(0, reader.GetStatistics().BytesSkipped);
    }

    [Fact]
    public void Wrong_arguments_are_refused()
    {
        Assert.Throws<ArgumentNullException>(() => new WebSocketSource(null!));
        Assert.Throws<ArgumentException>(() => new WebSocketSource(new Uri("http://studio")));
        Assert.Throws<ArgumentException>(() => new WebSocketSource(new Uri("/motion", UriKind.Relative)));
        Assert.Throws<ArgumentException>(() => new WebSocketSource(new Uri("ws://studio"), string.Empty));
        Assert.Throws<ArgumentException>(() => new WebSocketSource(new Uri("ws://studio"), "a\r\nb"));
        Assert.Throws<ArgumentException>(() => new WebSocketSource(new Uri("ws://studio"), " word"));
        Assert.Throws<ArgumentException>(() => new WebSocketSource(new Uri("ws://studio"), "wörd"));
        Assert.Equal("wss://studio/motion", new WebSocketSource(new Uri("wss://studio/motion?token=secret")).Name);
    }

    // A busy machine delays threads for seconds.
    private static WebSocketSource Source(string address, string? token = null) => new(new Uri(address), token) { ConnectTimeout = Limits.Unexpected };

    private static NeuronReaderOptions Options(WebSocketSource source, ReceiveThread thread = ReceiveThread.Auto) => new()
    {
        Source = source,
        ReceiveThread = thread,
        SilenceTimeout = Limits.Unexpected,
        StopTimeout = Limits.Unexpected,
        Reconnect = { Enabled = false },
    };
}
