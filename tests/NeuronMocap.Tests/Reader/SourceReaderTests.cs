using System.Net.Sockets;
using NeuronMocap.Recording;
using NeuronMocap.Tests.Network;
using NeuronMocap.Tests.Recording;

namespace NeuronMocap.Tests.Reader;

// Streams and sources in place of a connection, up to what an application sees.
public sealed class SourceReaderTests
{
    public static TheoryData<ReceiveThread> Threads => [ReceiveThread.Auto, ReceiveThread.Dedicated, ReceiveThread.Pool];

    public static TheoryData<Exception, ConnectionReason> Failures => new()
    {
        { new IOException("The cable was unplugged."), ConnectionReason.NetworkError },
        { new IOException("Reset.", new SocketException((int)SocketError.ConnectionReset)), ConnectionReason.Reset },
        { new UnauthorizedAccessException("Not allowed."), ConnectionReason.AccessDenied },
        { new TimeoutException("Too late."), ConnectionReason.TimedOut },
        { new OperationCanceledException("Cancelled by its owner."), ConnectionReason.NetworkError },
        { new InvalidOperationException("Blocking reads are not allowed."), ConnectionReason.NetworkError },
    };

    [Theory]
    [MemberData(nameof(Threads))]
    public async Task Every_way_of_delivery_works(ReceiveThread thread)
    {
        using var stream = new FedStream();
        await using var reader = new NeuronReader(stream, Options(thread));
        int called = 0;
        reader.MotionReceived += _ => called++;
        using FrameQueue queue = reader.OpenQueue();
        using LatestFrames latest = reader.OpenLatest();
        IAsyncEnumerator<MotionFrame> frames = reader.ReadMotionAsync(TestContext.Current.CancellationToken).GetAsyncEnumerator(TestContext.Current.CancellationToken);
        ValueTask<bool> first = frames.MoveNextAsync();
        byte[] bytes = TestPackets.Join(TestPackets.Motions(0, 3), TestPackets.Calculation(4));
        stream.Feed(bytes, [1, 2, 3], TestPackets.Motion(5)[..700]).End();

        await reader.Completion.Soon();
        Assert.True(await first);
        Assert.Equal(0f, frames.Current.Values[0]);
        await frames.DisposeAsync();
        Assert.Equal((3, 4), (called, queue.Pump<AvatarFrame>(static _ => { })));
        Assert.True(latest.TryTakeMotion(0, out MotionFrame? newest));
        Assert.Equal(2f, newest.Values[0]);

        ReaderStatistics statistics = reader.GetStatistics();
        Assert.Equal((3, 1, 703, bytes.Length + 703), (statistics.MotionFrames, statistics.CalculationFrames, statistics.BytesSkipped, statistics.BytesReceived));
        Assert.Equal(
            (ConnectionState.Stopped, ConnectionReason.ClosedByPeer, "Receiving from the stream has ended: there are no more bytes."),
            (reader.Status.State, reader.Status.Reason, reader.Status.Message));
        await Limits.UntilAsync(() => stream.IsDisposed);
    }

    [Fact]
    public async Task The_status_names_the_source_and_the_thread()
    {
        using var stream = new FedStream();
        await using var reader = new NeuronReader(new NeuronReaderOptions
        {
            Source = new ListedSource(() => stream),
            ReceiveThread = ReceiveThread.Dedicated,
            Transport = TransportKind.Udp,
            CalculationPort = 7003,
        });
        var log = new StatusLog(reader);
        reader.Start();
        stream.Feed(TestPackets.Motion(1));
        ConnectionStatus status = await log.WaitAsync(ConnectionState.Receiving);
        Assert.Equal((ReceiveThread.Dedicated, null, null), (status.ReceiveThread, status.LocalEndPoint, status.RemoteEndPoint));
        Assert.StartsWith("Receiving from the list: binary format; ", status.Message, StringComparison.Ordinal);
        Assert.Equal(
            ["Connecting to the list.", "Connected to the list; waiting for frames."],
            log.All.Take(2).Select(static earlier => earlier.Message));
        Assert.Equal("the list", reader.Name);
        Assert.Null(reader.CalculationStatus);
    }

    [Theory]
    [MemberData(nameof(Failures), DisableDiscoveryEnumeration = true)]
    public async Task A_failure_of_the_stream_is_the_reason(Exception failure, ConnectionReason reason)
    {
        foreach (ReceiveThread thread in (ReceiveThread[])[ReceiveThread.Auto, ReceiveThread.Dedicated])
        {
            using var stream = new FedStream();
            await using var reader = new NeuronReader(stream, Options(thread));
            reader.Start();
            stream.Feed(TestPackets.Motion(1)).End(failure);
            await reader.Completion.Soon();
            Assert.Equal((reason, $"Receiving from the stream failed: {failure.Message}"), (reader.Status.Reason, reader.Status.Message));
            Assert.Equal(1, reader.GetStatistics().MotionFrames);
        }
    }

    // On Windows, the empty read of a serial port never ends. Other streams answer it at once.
    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public async Task A_stream_need_not_support_empty_reads(bool answers)
    {
        var never = new TaskCompletionSource<int>();
        using var stream = new FedStream { EmptyRead = () => answers ? Task.FromResult(0) : never.Task };
        await using var reader = new NeuronReader(stream, Options());
        reader.Start();
        for (int i = 1; i <= 3; i++)
        {
            stream.Feed(TestPackets.Motion(i));
            await reader.WaitForFramesAsync(i);
        }

        stream.End();
        await reader.Completion.Soon();
        Assert.Equal((3, 0), (reader.GetStatistics().MotionFrames, reader.GetStatistics().BytesSkipped));
    }

    [Fact]
    public async Task A_source_is_opened_again()
    {
        byte[] frame = TestPackets.Motion(1);
        var cut = new IOException("Cut.");
        Func<Stream>[] streams =
        [
            static () => throw new NeuronConnectionException(ConnectionReason.Refused, "Nobody is there."),
            static () => throw new IOException("No such port."),
            static () => null!,
            () => new FedStream().Feed(TestPackets.Motion(0), frame[..700]).End(),
            () => new FedStream().Feed(frame[700..], frame).End(cut),
            () => new FedStream().Feed(TestPackets.Motion(2)),
        ];
        await using var reader = new NeuronReader(Options(source: new ListedSource(streams)));
        using FrameQueue queue = reader.OpenQueue();
        var log = new StatusLog(reader);
        reader.Start();
        await reader.WaitForFramesAsync(3);

        List<float> frames = [];
        queue.Pump<MotionFrame>(motion => frames.Add(motion.Values[0]));
        Assert.Equal([0, 1, 2], frames);
        Assert.Equal(2, reader.GetStatistics().Reconnects);
        Assert.Equal(frame.Length, reader.GetStatistics().BytesSkipped);
        ConnectionStatus[] waits = [.. log.All.Where(static status => status.State == ConnectionState.Waiting)];
        Assert.Equal(
            [ConnectionReason.Refused, ConnectionReason.NetworkError, ConnectionReason.NetworkError, ConnectionReason.ClosedByPeer, ConnectionReason.NetworkError],
            waits.Select(static status => status.Reason));
        Assert.Equal(
            [
                "Opening the list failed: Nobody is there.",
                "Opening the list failed: No such port.",
                "Opening the list failed: The source returned no stream.",
                "Receiving from the list has ended: there are no more bytes.",
                "Receiving from the list failed: Cut.",
            ],
            waits.Select(static status => status.Message));
    }

    [Fact]
    public async Task A_single_stream_is_not_read_again()
    {
        await using var reader = new NeuronReader(new FedStream().End(new IOException("Cut.")), Options());
        reader.Start();
        await reader.Completion.Soon();
        Assert.Equal((ConnectionState.Stopped, ConnectionReason.NetworkError), (reader.Status.State, reader.Status.Reason));
    }

    [Fact]
    public async Task Silence_is_explained()
    {
        using var stream = new FedStream();
        NeuronReaderOptions options = Options();
        options.SilenceTimeout = TimeSpan.FromSeconds(0.1);
        await using var reader = new NeuronReader(stream, options);
        var log = new StatusLog(reader);
        reader.Start();
        ConnectionStatus status = await log.WaitAsync(ConnectionState.Silent);
        Assert.Equal(ConnectionReason.NoData, status.Reason);
        Assert.Equal(
            "Nothing has arrived from the stream for 0.1 s. Check that the program that writes to it runs, and that it sends BVH or calculation data.", status.Message);
    }

    [Theory]
    [MemberData(nameof(Threads))]
    public async Task A_recording_holds_every_byte(ReceiveThread thread)
    {
        using var folder = new RecordingFolder();
        string path = folder.PathOf("stream.nmrec");
        byte[] bytes = TestPackets.Join(TestPackets.Motions(0, 50), new byte[100], TestPackets.Line(50));
        await using (var reader = new NeuronReader(new FedStream().Feed([.. bytes.Chunk(777)]).End(), Options(thread)))
        {
            StreamRecorder recorder = reader.StartRecording(path);
            reader.Start();
            await reader.Completion.Soon();
            await recorder.Completion.Soon();
            Assert.Equal((bytes.Length, 0), (recorder.GetStatistics().Bytes, recorder.GetStatistics().LostBytes));
        }

        using (RecordingReader recording = RecordingReader.Open(path))
            Assert.Equal("the stream", recording.Metadata[RecordingMetadata.ServerKey]);

        using RecordingPlayer player = RecordingPlayer.Open(path);
        player.Speed = RecordingPlayer.MaxSpeed;
        await using var played = new NeuronReader(player);
        played.Start();
        await played.Completion.Soon();
        Assert.Equal((51, bytes.Length), (played.GetStatistics().MotionFrames, played.GetStatistics().BytesReceived));
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public async Task The_stream_is_disposed_unless_it_is_left_open(bool leaveOpen)
    {
        foreach (bool starts in (bool[])[false, true])
        {
            using var stream = new FedStream();
            var reader = new NeuronReader(stream, Options(), leaveOpen);
            if (starts)
                await reader.StartAsync().Soon();

            await reader.DisposeAsync();
            Assert.Equal(!leaveOpen, stream.IsDisposed);
            Assert.Equal(ConnectionReason.Requested, reader.Status.Reason);
        }
    }

    [Fact]
    public async Task A_source_that_does_not_open_is_the_thing_to_check()
    {
        await using var reader = new NeuronReader(Options(source: new ListedSource()));
        var log = new StatusLog(reader);
        reader.Start();
        await log.WaitAsync(ConnectionState.Connecting);
        NeuronConnectionException exception =
            await Assert.ThrowsAsync<NeuronConnectionException>(() => reader.StartAsync(TimeSpan.FromMilliseconds(50), TestContext.Current.CancellationToken)).Soon();
        Assert.Equal(ConnectionReason.TimedOut, exception.Reason);
        Assert.Equal(
            "There was no connection within 0.05 s. The reader continues to try. Connecting to the list. It has not opened yet: check the device, the program or "
            + "the tunnel that it opens.",
            exception.Message);
    }

    [Fact]
    public void A_stream_that_cannot_be_read_is_refused()
    {
        var disposed = new FedStream();
        disposed.Dispose();
        Assert.Throws<ArgumentException>("stream", () => new NeuronReader(disposed));
        Assert.Throws<ArgumentNullException>("stream", () => new NeuronReader((Stream)null!));
    }

    internal static NeuronReaderOptions Options(ReceiveThread thread = ReceiveThread.Auto, ByteSource? source = null) => new()
    {
        Source = source,
        ReceiveThread = thread,
        SilenceTimeout = Limits.Unexpected,
        StopTimeout = Limits.Unexpected,
        Reconnect = { InitialDelay = TimeSpan.FromMilliseconds(1), MaxDelay = TimeSpan.FromMilliseconds(5) },
    };
}
