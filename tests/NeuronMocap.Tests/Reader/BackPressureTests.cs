using System.Net;
using System.Net.Sockets;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Reader;

/// <summary>What full queues do on a real connection, with other threads competing for the processors.</summary>
[Collection(nameof(Alone))]
public sealed class BackPressureTests : IDisposable
{
    private const int Sent = 12_000;

    private static readonly Lazy<byte[]> LazyStream =
        new(() => TestPackets.Join(Enumerable.Range(0, Sent).Select(static frame => TestPackets.Motion(frame, count: 180))));

    private readonly TestServer _server = new();

    [Theory]
    [InlineData(1)]
    [InlineData(64)]
    public async Task A_queue_that_waits_loses_nothing_at_full_speed(int capacity)
    {
        await using var reader = new NeuronReader(_server.Options());
        using FrameQueue queue = reader.OpenQueue(new FrameQueueOptions { Capacity = capacity, WhenFull = WhenFull.Wait });
        using FrameQueue other = reader.OpenQueue(Sent);
        reader.Start();
        using TestConnection connection = await _server.AcceptAsync();
        using (new Preemption())
        {
            Task sending = connection.SendPiecesAsync(LazyStream.Value, 50_000);
            var random = new Random(1);
            uint next = 0;
            while (next < Sent)
            {
                int taken = queue.Pump<MotionFrame>(frame =>
                {
                    Assert.Equal(next++, frame.FrameIndex);
                    Preemption.Stumble(random);
                });
                if (taken == 0)
                    Thread.Yield();
            }

            await sending.Soon();
        }

        await reader.WaitForFramesAsync(Sent);
        Assert.Equal((Sent, 0, 0), (queue.Delivered, queue.Dropped, queue.Count));
        Assert.Equal((Sent, 0), (other.Count, reader.GetStatistics().Lost));
    }

    [Fact]
    public async Task An_enumeration_that_waits_loses_nothing()
    {
        await using var reader = new NeuronReader(_server.Options());
        using var source = CancellationTokenSource.CreateLinkedTokenSource(TestContext.Current.CancellationToken);
        source.CancelAfter(Limits.Unexpected);
        Task<TestConnection> accepting = _server.AcceptAsync();
        Task sending = SendAsync();
        uint next = 0;
        await foreach (MotionFrame frame in reader.ReadMotionAsync(new FrameQueueOptions { Capacity = 4, WhenFull = WhenFull.Wait }, source.Token))
        {
            Assert.Equal(next++, frame.FrameIndex);
            if (next % 64 == 0)
                await Task.Yield();
        }

        Assert.Equal((uint)Sent, next);
        await sending.Soon();
        Assert.Equal(0, reader.GetStatistics().Dropped);

        async Task SendAsync()
        {
            using TestConnection connection = await accepting;
            await connection.SendPiecesAsync(LazyStream.Value, 50_000);
            connection.Close();
        }
    }

    [Fact]
    public async Task A_queue_that_drops_its_oldest_adds_up_while_both_threads_run()
    {
        await using var reader = new NeuronReader(_server.Options());
        using FrameQueue queue = reader.OpenQueue(new FrameQueueOptions { Capacity = 8, WhenFull = WhenFull.DropOldest, EveryNth = 2 });
        reader.Start();
        using TestConnection connection = await _server.AcceptAsync();
        long last = -1;
        int handled = 0;
        using (new Preemption())
        {
            Task sending = connection.SendPiecesAsync(LazyStream.Value, 50_000);
            var random = new Random(1);
            while (last < Sent - 2)
            {
                int taken = queue.Pump<MotionFrame>(frame =>
                {
                    uint number = frame.FrameIndex!.Value;
                    Assert.True(number > last, $"{number} after {last}");
                    Preemption.Stumble(random);
                    for (int value = 0; value < frame.Values.Length; value++)
                        Assert.Equal(TestPackets.Value((int)number, 0, value), frame.Values[value]);

                    last = number;
                    handled++;
                });
                if (taken == 0)
                    Thread.Yield();
            }

            await sending.Soon();
        }

        await reader.WaitForFramesAsync(Sent);
        Assert.Equal((Sent / 2, handled), (queue.Skipped, queue.Delivered));
        Assert.Equal(Sent, queue.Delivered + queue.Dropped + queue.Skipped + queue.Count);
        Assert.Equal(0, reader.GetStatistics().Lost);
    }

    // The receive thread waits in a full queue when each of these ends the wait.
    [Theory]
    [InlineData("queue")]
    [InlineData("reader")]
    [InlineData("reader in a handler")]
    [InlineData("reader asynchronously")]
    [InlineData("delivery")]
    public async Task Whatever_ends_the_consumer_ends_the_wait(string how)
    {
        var reader = new NeuronReader(_server.Options());
        var options = new FrameQueueOptions { Capacity = 2, WhenFull = WhenFull.Wait };
        using FrameQueue? queue = how == "delivery" ? null : reader.OpenQueue(options);
        using FrameDelivery? delivery = how == "delivery"
            ? reader.OpenDelivery(new FrameDeliveryOptions { Post = static _ => true, Capacity = 2, WhenFull = WhenFull.Wait })
            : null;
        reader.Start();
        using TestConnection connection = await _server.AcceptAsync();
        await connection.SendAsync(TestPackets.Motions(0, 5));
        await Limits.UntilAsync(() => reader.GetStatistics().MotionFrames == 3 && reader.IsDelivering);
        switch (how)
        {
            case "queue":
                queue!.Dispose();
                await reader.WaitForFramesAsync(5);
                break;
            case "delivery":
                delivery!.Dispose();
                await reader.WaitForFramesAsync(5);
                break;
            case "reader in a handler":
                await Task.Run(() => queue!.Pump<MotionFrame>(_ => reader.Dispose(), maxFrames: 1), TestContext.Current.CancellationToken).Soon();
                break;
            case "reader asynchronously":
                await reader.DisposeAsync().AsTask().Soon();
                break;
        }

        await Task.Run(reader.Dispose, TestContext.Current.CancellationToken).Soon();
        await reader.Completion.Soon();
        if (how.StartsWith("reader", StringComparison.Ordinal))
            Assert.Equal(reader.GetStatistics().Frames, queue!.Delivered + queue.Dropped + queue.Count);
    }

    [Fact]
    public async Task Both_connections_of_a_reader_wait_and_stop_together()
    {
        using var calculationServer = new TestServer();
        NeuronReaderOptions options = _server.Options();
        options.CalculationPort = calculationServer.Port;
        using var reader = new NeuronReader(options);
        using FrameQueue queue = reader.OpenQueue(new FrameQueueOptions { Capacity = 2, WhenFull = WhenFull.Wait });
        reader.Start();
        using TestConnection motion = await _server.AcceptAsync();
        using TestConnection calculation = await calculationServer.AcceptAsync();
        await motion.SendAsync(TestPackets.Motions(0, 5));
        await Limits.UntilAsync(() => reader.GetStatistics().MotionFrames == 3 && reader.IsDelivering);
        await calculation.SendAsync(TestPackets.Calculation(1));
        Assert.Equal(0, reader.GetStatistics().CalculationFrames);
        await reader.DisposeAsync().AsTask().Soon();
        await reader.Completion.Soon();
    }

    [Fact]
    public async Task Over_UDP_the_system_keeps_the_datagrams_while_a_queue_waits()
    {
        // They fit the smallest buffer that a system grants.
        const int Datagrams = 20;
        var options = new NeuronReaderOptions { Transport = TransportKind.Udp, LocalAddress = IPAddress.Loopback, Port = 0, Reconnect = { Enabled = false } };
        await using var reader = new NeuronReader(options);
        using FrameQueue queue = reader.OpenQueue(new FrameQueueOptions { Capacity = 2, WhenFull = WhenFull.Wait });
        await reader.StartAsync(TestContext.Current.CancellationToken);
        using var sender = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
        sender.Connect(reader.Status.LocalEndPoint!);
        for (int i = 0; i < Datagrams; i++)
            sender.Send(TestPackets.Motion(i));

        await Limits.UntilAsync(() => reader.GetStatistics().MotionFrames == 3 && reader.IsDelivering);
        Assert.Equal(2, queue.Count);

        List<uint?> indices = [];
        while (indices.Count < Datagrams && await queue.WaitAsync(TestContext.Current.CancellationToken).AsTask().Soon())
            queue.Pump<MotionFrame>(frame => indices.Add(frame.FrameIndex));

        Assert.Equal(Enumerable.Range(0, Datagrams).Select(static index => (uint?)index), indices);
        Assert.Equal((0L, 0L), (queue.Dropped, reader.GetStatistics().Lost));
    }

    [Theory]
    [InlineData("WhenFull")]
    [InlineData("MaxRate")]
    [InlineData("EveryNth")]
    [InlineData("Capacity")]
    [InlineData("Name")]
    [InlineData("MaxRate and EveryNth")]
    public void An_option_out_of_range_is_refused_by_name(string name)
    {
        using var reader = new NeuronReader("127.0.0.1");
        var options = new FrameQueueOptions();
        switch (name)
        {
            case "WhenFull":
                options.WhenFull = (WhenFull)3;
                break;
            case "MaxRate":
                options.MaxRate = double.NaN;
                break;
            case "EveryNth":
                options.EveryNth = 0;
                break;
            case "Capacity":
                options.Capacity = 0;
                break;
            case "Name":
                options.Name = " ";
                break;
            default:
                (options.MaxRate, options.EveryNth) = (60, 2);
                break;
        }

        Assert.StartsWith(name, Assert.Throws<ArgumentException>(() => reader.OpenQueue(options)).Message, StringComparison.Ordinal);
        Assert.StartsWith(name, Assert.Throws<ArgumentException>(() => reader.ReadMotionAsync(options)).Message, StringComparison.Ordinal);
        var view = new LatestFramesOptions { MaxRate = options.MaxRate, EveryNth = options.EveryNth };
        if (name.Contains("Rate", StringComparison.Ordinal) || name.Contains("Nth", StringComparison.Ordinal))
            Assert.Throws<ArgumentException>(() => reader.OpenLatest(view));
    }

    public void Dispose() => _server.Dispose();
}
