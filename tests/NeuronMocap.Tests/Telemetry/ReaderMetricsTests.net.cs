using System.Diagnostics;
using System.Diagnostics.Metrics;
using System.Net;
using System.Runtime.CompilerServices;
using NeuronMocap.Delivery;
using NeuronMocap.Telemetry;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Telemetry;

public sealed class ReaderMetricsTests
{
    [Fact]
    public async Task Counters_match_the_statistics()
    {
        using var server = new TestServer();
        using var reader = Reader(server, "counters");
        using var log = new MetricsLog("counters");
        using FrameQueue small = reader.OpenQueue(2, "small");
        using FrameQueue large = reader.OpenQueue(64);
        reader.MotionReceived += _ => throw new InvalidOperationException("no disk");
        reader.Start();
        using TestConnection connection = await server.AcceptAsync();
        await connection.SendAsync(TestPackets.Join(
            [TestPackets.Motion(1), TestPackets.Motion(2), new byte[100], TestPackets.Motion(5), TestPackets.Calculation(1), TestPackets.Motion(6)]));
        await reader.WaitForFramesAsync(4);
        await Limits.UntilAsync(() => large.Count == 5);

        string[] measured = log.Collect();
        foreach (string expected in (string[])
            [
                "neuron.reader.frames neuron.frame.kind=motion: 4", "neuron.reader.frames neuron.frame.kind=calculation: 1",
                $"neuron.reader.io: {(4 * 1480) + 100 + 3848}", "neuron.reader.skipped neuron.skip.reason=no_tokens: 100",
                "neuron.reader.skipped neuron.skip.reason=too_large: 0", "neuron.reader.skipped neuron.skip.reason=incomplete: 0",
                "neuron.reader.skipped neuron.skip.reason=unknown_version: 0", "neuron.reader.dropped neuron.consumer.name=small: 3",
                "neuron.reader.dropped neuron.consumer.name=queue: 0", "neuron.reader.queue.length neuron.consumer.name=small: 2",
                "neuron.reader.queue.length neuron.consumer.name=queue: 5", "neuron.reader.lost: 2", "neuron.reader.gaps: 1",
                "neuron.reader.restarts: 0", "neuron.reader.reconnects: 0", "neuron.reader.refused: 0", "neuron.reader.failures: 4",
                "neuron.reader.state neuron.connection.state=receiving: 1", "neuron.reader.state neuron.connection.state=silent: 0",
            ])
        {
            Assert.Contains(expected, measured);
        }

        (_, double age, _) = Assert.Single(log.Measurements, measurement => measurement.Name == "neuron.reader.frame.age");
        Assert.InRange(age, 0, Limits.Unexpected.TotalSeconds);
    }

    [Fact]
    public async Task Drops_of_closed_queues_stay_counted()
    {
        using var server = new TestServer();
        using var reader = Reader(server, "closed queues");
        using var log = new MetricsLog("closed queues");
        reader.Start();
        using TestConnection connection = await server.AcceptAsync();
        for (int i = 0; i < 3; i++)
        {
            using FrameQueue queue = reader.OpenQueue(1, "brief");
            await connection.SendAsync(TestPackets.Motions(1 + (i * 5), 5));
            await reader.WaitForFramesAsync((i + 1) * 5);
        }

        Assert.Contains("neuron.reader.dropped neuron.consumer.name=brief: 12", log.Collect());
    }

    [Fact]
    public async Task Skipped_frames_are_counted_by_consumer_and_are_not_lost()
    {
        using var server = new TestServer();
        using var reader = Reader(server, "skips");
        using var log = new MetricsLog("skips");
        using LatestFrames latest = reader.OpenLatest(new LatestFramesOptions { EveryNth = 5 });
        reader.OpenQueue(new FrameQueueOptions { Name = "closed", EveryNth = 2 }).Dispose();
        using FrameQueue queue = reader.OpenQueue(new FrameQueueOptions { Name = "thin", EveryNth = 2 });
        reader.Start();
        using TestConnection connection = await server.AcceptAsync();
        await connection.SendAsync(TestPackets.Motions(1, 10));
        await reader.WaitForFramesAsync(10);

        string[] measured = log.Collect();
        Assert.Contains("neuron.reader.frames.skipped neuron.consumer.name=thin: 5", measured);
        Assert.Contains("neuron.reader.frames.skipped neuron.consumer.name=latest: 8", measured);
        Assert.Contains("neuron.reader.frames.skipped neuron.consumer.name=closed: 0", measured);
        Assert.Contains("neuron.reader.dropped neuron.consumer.name=thin: 0", measured);
        ReaderStatistics statistics = reader.GetStatistics();
        Assert.Equal((13, 0, 0), (statistics.Skipped, statistics.Dropped, statistics.Lost));
    }

    [Fact]
    public async Task The_granted_receive_buffer_is_told_beside_the_requested_one()
    {
        using var reader = new NeuronReader(new NeuronReaderOptions { Name = "buffer", Transport = TransportKind.Udp, LocalAddress = IPAddress.Loopback, Port = 0 });
        using var log = new MetricsLog("buffer");
        Assert.DoesNotContain(log.Collect(), static measured => measured.Contains("receive.buffer", StringComparison.Ordinal));
        await reader.StartAsync().Soon();
        string[] measured = log.Collect();
        Assert.Contains($"neuron.reader.receive.buffer neuron.buffer.size=granted: {reader.Status.ReceiveBufferSize}", measured);
        Assert.Contains("neuron.reader.receive.buffer neuron.buffer.size=requested: 4194304", measured);
        Assert.Equal(4_194_304, reader.Status.RequestedReceiveBufferSize);
    }

    [Fact]
    public async Task Times_are_recorded_while_observed()
    {
        using var server = new TestServer();
        using var reader = Reader(server, "times");
        using FrameQueue queue = reader.OpenQueue(64, "draw");
        LatestFrames latest = reader.OpenLatest();
        reader.Start();
        using TestConnection connection = await server.AcceptAsync();
        using var log = new MetricsLog("times");
        await connection.SendAsync(TestPackets.Motions(1, 10));
        await reader.WaitForFramesAsync(10);
        await Limits.UntilAsync(() => queue.Count == 10);
        queue.Pump<AvatarFrame>(static _ => { });
        await Limits.UntilAsync(() => latest.TryTakeMotion(0, out _));

        (string Name, double Value, string Tags)[] recorded = log.Measurements;
        Assert.Equal(9, recorded.Count(measurement => measurement is { Name: "neuron.reader.frame.interval", Tags: " neuron.frame.kind=motion" }));
        Assert.Equal(10, recorded.Count(measurement =>
            measurement is { Name: "neuron.reader.handover.duration", Tags: " neuron.consumer.name=draw neuron.frame.kind=motion" }));
        Assert.Equal(1, recorded.Count(measurement =>
            measurement is { Name: "neuron.reader.handover.duration", Tags: " neuron.consumer.name=latest neuron.frame.kind=motion" }));
        Assert.All(recorded, measurement => Assert.InRange(measurement.Value, 0, Limits.Unexpected.TotalSeconds));
    }

    [Fact]
    public void Names_units_and_descriptions_follow_the_conventions()
    {
        using var reader = new NeuronReader("127.0.0.1");
        using var log = new MetricsLog("none");
        Assert.Equal(17, log.Instruments.Count);
        Assert.All(log.Instruments, instrument =>
        {
            Assert.Matches("^neuron\\.reader(\\.[a-z]+)+$", instrument.Name);
            Assert.Matches("^(s|By|\\{[a-z]+\\})$", instrument.Unit);
            Assert.EndsWith(".", instrument.Description, StringComparison.Ordinal);
        });
        Assert.All(log.Instruments.OfType<Histogram<double>>(), histogram => Assert.NotNull(histogram.Advice?.HistogramBucketBoundaries));
    }

    [Fact]
    public void A_disposed_reader_reports_no_metrics()
    {
        using var log = new MetricsLog("gone");
        using (var reader = new NeuronReader(new NeuronReaderOptions { Name = "gone" }))
            Assert.NotEmpty(log.Collect());

        Assert.Empty(log.Collect());
    }

    [Fact]
    public void Readers_of_equal_name_are_distinguished_and_names_are_reused()
    {
        var first = new NeuronReader(new NeuronReaderOptions { Name = "twin" });
        using var second = new NeuronReader(new NeuronReaderOptions { Name = "twin" });
        Assert.Equal(("twin", "twin (2)"), (first.Name, second.Name));
        first.Dispose();
        using var third = new NeuronReader(new NeuronReaderOptions { Name = "twin" });
        Assert.Equal("twin", third.Name);
    }

    [Fact]
    public async Task The_meter_does_not_keep_readers_alive()
    {
        List<WeakReference> started = [];
        for (int i = 0; i < 20; i++)
            started.Add(await UseAsync());

        List<WeakReference> forgotten = [.. Enumerable.Range(0, 20).Select(_ => Forget())];
        await Limits.UntilAsync(() =>
        {
            GC.Collect();
            GC.WaitForPendingFinalizers();
            return started.Concat(forgotten).Count(reference => reference.IsAlive) <= 1; // the runtime may keep the last one in a register
        });
    }

    [Fact]
    public void A_listener_that_throws_does_not_reach_the_receive_thread()
    {
        using var listener = new MeterListener();
        listener.InstrumentPublished = (instrument, self) =>
        {
            if (instrument.Name == "neuron.reader.frame.interval")
                self.EnableMeasurementEvents(instrument);
        };
        listener.SetMeasurementEventCallback<double>((_, value, _, _) =>
        {
            if (value > 1e6)
                throw new InvalidOperationException("no disk");
        });
        listener.Start();

        var recorder = new DurationRecorder(NeuronMeter.FrameInterval);
        Assert.True(recorder.IsEnabled);
        recorder.Record(PacketKind.Motion, (long)(2e6 * Stopwatch.Frequency));
    }

    [Fact]
    public void Recording_allocates_nothing()
    {
        using var log = new MeterListener();
        long recorded = 0;
        log.InstrumentPublished = (instrument, self) =>
        {
            if (instrument.Name is "neuron.reader.frame.interval" or "neuron.reader.handover.duration")
                self.EnableMeasurementEvents(instrument);
        };
        log.SetMeasurementEventCallback<double>((_, _, tags, _) => Interlocked.Add(ref recorded, tags.Length));
        log.Start();
        byte[] name = new byte[32];
        var tracker = new AvatarTracker(PacketKind.Motion, 0, 0, new DurationRecorder(NeuronMeter.FrameInterval, new KeyValuePair<string, object?>("a", "b")));
        uint index = 0;
        Allocations.AssertNone(() => tracker.OnFrame(name, index++, index * 1000));
        Assert.True(recorded >= 250);
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static WeakReference Forget() => new(new NeuronReader(new NeuronReaderOptions { Name = "forgotten" }));

    private static async Task<WeakReference> UseAsync()
    {
        using var server = new TestServer();
        var reader = Reader(server, "used");
        reader.Start();
        using TestConnection connection = await server.AcceptAsync();
        await connection.SendAsync(TestPackets.Motion(1));
        await reader.WaitForFramesAsync(1);
        await reader.DisposeAsync();
        return new WeakReference(reader);
    }

    private static NeuronReader Reader(TestServer server, string name)
    {
        NeuronReaderOptions options = server.Options();
        options.Name = name;
        return new NeuronReader(options);
    }
}
