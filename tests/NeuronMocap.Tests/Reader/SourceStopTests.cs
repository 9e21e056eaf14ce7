using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Reader;

// A reader must end in every state, whatever the code of a source or of a stream does.
public sealed class SourceStopTests : IDisposable
{
    private readonly ManualResetEventSlim _release = new();

    public static TheoryData<bool, ReceiveThread> Streams => new()
    {
        { false, ReceiveThread.Auto },
        { false, ReceiveThread.Dedicated },
        { true, ReceiveThread.Auto },
        { true, ReceiveThread.Dedicated },
    };

    public void Dispose() => _release.Set();

    [Theory]
    [MemberData(nameof(Streams))]
    public async Task While_a_read_waits(bool ignoresEnd, ReceiveThread thread)
    {
        foreach (int bytes in (int[])[0, 700, 1480, 2000])
        {
            var stream = new FedStream { IgnoresEnd = ignoresEnd };
            var reader = new NeuronReader(stream, SourceReaderTests.Options(thread));
            int called = 0;
            reader.MotionReceived += _ => called++;
            reader.Start();
            if (bytes > 0)
                stream.Feed(TestPackets.Motions(0, 2)[..bytes]);

            await Limits.UntilAsync(() => stream.Waiting > 0 && called == bytes / 1480);
            reader.Dispose();
            await AssertStoppedAsync(reader);
            await Limits.UntilAsync(() => stream.IsDisposed);

            // A read that only ends now delivers nothing.
            stream.Feed(TestPackets.Motion(3)).End();
            Assert.Equal(bytes / 1480, called);
        }
    }

    [Theory]
    [MemberData(nameof(Streams))]
    public async Task While_an_asynchronous_read_blocks_its_caller(bool ignoresEnd, ReceiveThread thread)
    {
        foreach (int frames in (int[])[0, 1])
        {
            var stream = new FedStream { IgnoresEnd = ignoresEnd, BlocksCallers = true };
            var reader = new NeuronReader(stream, SourceReaderTests.Options(thread));
            if (frames > 0)
                stream.Feed(TestPackets.Motions(0, frames));

            reader.Start();
            await Limits.UntilAsync(() => stream.Waiting > 0 && reader.GetStatistics().MotionFrames == frames);
            reader.Dispose();
            await AssertStoppedAsync(reader);
            await Limits.UntilAsync(() => stream.IsDisposed);
            stream.Feed(TestPackets.Motion(3)).End();
            Assert.Equal(frames, reader.GetStatistics().MotionFrames);
        }
    }

    [Theory]
    [InlineData(ReceiveThread.Auto)]
    [InlineData(ReceiveThread.Dedicated)]
    public async Task While_a_read_of_a_stream_that_is_left_open_waits(ReceiveThread thread)
    {
        using var stream = new FedStream();
        var reader = new NeuronReader(stream, SourceReaderTests.Options(thread), leaveOpen: true);
        reader.Start();
        await Limits.UntilAsync(() => stream.Waiting > 0);
        reader.Dispose();
        await AssertStoppedAsync(reader);
        Assert.False(stream.IsDisposed);
    }

    [Fact]
    public async Task While_the_disposal_of_the_stream_blocks()
    {
        var stream = new FedStream { Disposing = () => _release.Wait() };
        NeuronReaderOptions options = SourceReaderTests.Options();
        options.StopTimeout = TimeSpan.FromSeconds(2);
        var reader = new NeuronReader(stream, options);
        await reader.StartAsync().Soon();
        reader.Dispose();
        await AssertStoppedAsync(reader);
        Assert.False(stream.IsDisposed);
    }

    // The read ends first, on the thread that disposes the stream.
    [Theory]
    [InlineData(ReceiveThread.Auto)]
    [InlineData(ReceiveThread.Dedicated)]
    public async Task After_the_disposal_of_the_stream(ReceiveThread thread)
    {
        NeuronReader? reader = null;
        bool wasStopped = false;
        var stream = new FedStream { Disposing = () => wasStopped = reader!.Completion.IsCompleted };
        reader = new NeuronReader(stream, SourceReaderTests.Options(thread));
        reader.Start();
        await Limits.UntilAsync(() => stream.Waiting > 0);
        reader.Dispose();
        await AssertStoppedAsync(reader);
        Assert.True(stream.IsDisposed);
        Assert.False(wasStopped);
    }

    [Fact]
    public async Task While_the_disposal_of_the_stream_throws()
    {
        var stream = new FedStream { Disposing = static () => throw new IOException("Not now.") };
        var reader = new NeuronReader(stream, SourceReaderTests.Options());
        await reader.StartAsync().Soon();
        reader.Dispose();
        await AssertStoppedAsync(reader);
        var unused = new NeuronReader(stream, SourceReaderTests.Options());
        unused.Dispose();
        await AssertStoppedAsync(unused);
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public async Task While_the_source_opens(bool blocks)
    {
        var late = new FedStream();
        var source = new SlowSource(late, _release, blocks);
        var reader = new NeuronReader(SourceReaderTests.Options(source: source));
        reader.Start();
        await Limits.UntilAsync(() => source.IsOpening);
        reader.Dispose();
        await AssertStoppedAsync(reader);

        // Nobody needs the stream any more.
        _release.Set();
        await Limits.UntilAsync(() => late.IsDisposed);
    }

    [Fact]
    public async Task While_waiting_for_the_next_attempt()
    {
        NeuronReaderOptions options = SourceReaderTests.Options(source: new ListedSource(static () => new FedStream().End()));
        options.Reconnect.InitialDelay = options.Reconnect.MaxDelay = TimeSpan.FromHours(1);
        var reader = new NeuronReader(options);
        var log = new StatusLog(reader);
        reader.Start();
        await log.WaitAsync(ConnectionState.Waiting);
        reader.Dispose();
        await AssertStoppedAsync(reader);
    }

    [Theory]
    [MemberData(nameof(Streams))]
    public async Task From_a_handler_of_frames(bool ignoresEnd, ReceiveThread thread)
    {
        var stream = new FedStream { IgnoresEnd = ignoresEnd };
        var reader = new NeuronReader(stream, SourceReaderTests.Options(thread));
        int frames = 0;
        reader.MotionReceived += _ =>
        {
            frames++;
            reader.Dispose();
        };
        reader.Start();
        stream.Feed(TestPackets.Motions(0, 100));
        await AssertStoppedAsync(reader);
        Assert.Equal(1, frames);
        await Limits.UntilAsync(() => stream.IsDisposed);
    }

    [Theory]
    [InlineData(ConnectionState.Connecting)]
    [InlineData(ConnectionState.Connected)]
    [InlineData(ConnectionState.Receiving)]
    [InlineData(ConnectionState.Waiting)]
    public async Task From_a_handler_of_the_status(ConnectionState state)
    {
        var source = new ListedSource(static () => new FedStream().Feed(TestPackets.Motion(1)).End());
        var reader = new NeuronReader(SourceReaderTests.Options(source: source));
        reader.StatusChanged += status =>
        {
            if (status.State == state)
                reader.Dispose();
        };
        reader.Start();
        await AssertStoppedAsync(reader);
    }

    [Theory]
    [MemberData(nameof(Streams))]
    public async Task From_many_threads_at_any_moment_of_a_start(bool ignoresEnd, ReceiveThread thread)
    {
        for (int round = 0; round < 50; round++)
        {
            var stream = new FedStream { IgnoresEnd = ignoresEnd };
            var reader = new NeuronReader(stream, SourceReaderTests.Options(thread));
            stream.Feed(TestPackets.Motions(0, 20));
            Task starting = Task.Run(reader.Start);
            Thread.SpinWait(round * 50);
            await Task.WhenAll(Enumerable.Range(0, 3).Select(_ => Task.Run(reader.Dispose))).Soon();
            await starting.ContinueWith(static _ => { }, TaskScheduler.Default).Soon();
            await AssertStoppedAsync(reader);
            await Limits.UntilAsync(() => stream.IsDisposed);
            stream.End();
        }
    }

    private static async Task AssertStoppedAsync(NeuronReader reader)
    {
        await reader.Completion.Soon();
        Assert.Equal((ConnectionState.Stopped, ConnectionReason.Requested), (reader.Status.State, reader.Status.Reason));
    }

    // Ignores the cancellation.
    private sealed class SlowSource(Stream stream, ManualResetEventSlim release, bool blocks) : ByteSource
    {
        private volatile bool _isOpening;

        public bool IsOpening => _isOpening;

        public override async ValueTask<Stream> OpenAsync(CancellationToken cancellationToken)
        {
            _isOpening = true;
            if (blocks)
                release.Wait(CancellationToken.None);
            else
                await Task.Run(() => release.Wait(CancellationToken.None), CancellationToken.None);

            return stream;
        }
    }
}
