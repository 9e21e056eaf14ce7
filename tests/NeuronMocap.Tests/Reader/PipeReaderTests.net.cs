using System.IO.Pipelines;
using NeuronMocap.Diagnostics;
using NeuronMocap.Recording;
using NeuronMocap.Tests.Diagnostics;
using NeuronMocap.Tests.Network;
using NeuronMocap.Tests.Recording;

namespace NeuronMocap.Tests.Reader;

// A pipe in place of a connection. SourceReaderTests has what all sources share.
public sealed class PipeReaderTests
{
    [Fact]
    public async Task Frames_statistics_status_and_recording_are_those_of_the_bytes()
    {
        using var folder = new RecordingFolder();
        var pipe = new Pipe();
        await using var reader = new NeuronReader(pipe.Reader, SourceReaderTests.Options());
        using FrameQueue queue = reader.OpenQueue();
        var log = new StatusLog(reader);
        StreamRecorder recorder = reader.StartRecording(folder.PathOf("pipe.nmrec"));
        reader.Start();
        byte[] bytes = TestPackets.Join([1, 2, 3], TestPackets.Motions(0, 100), TestPackets.Line(100));
        foreach (byte[] piece in bytes.Chunk(1000))
            await pipe.Writer.WriteAsync(piece, TestContext.Current.CancellationToken);

        ConnectionStatus receiving = await log.WaitAsync(ConnectionState.Receiving);
        Assert.StartsWith("Receiving from the pipe: ", receiving.Message, StringComparison.Ordinal);
        Assert.Equal(ReceiveThread.Pool, receiving.ReceiveThread);
        await pipe.Writer.CompleteAsync();
        await reader.Completion.Soon();
        await recorder.Completion.Soon();
        Assert.Equal(
            (ConnectionReason.ClosedByPeer, "Receiving from the pipe has ended: there are no more bytes."), (reader.Status.Reason, reader.Status.Message));
        Assert.Equal((101, 3, bytes.Length), (reader.GetStatistics().MotionFrames, reader.GetStatistics().BytesSkipped, reader.GetStatistics().BytesReceived));
        Assert.Equal((bytes.Length, 0), (recorder.GetStatistics().Bytes, recorder.GetStatistics().LostBytes));
        int next = 0;
        Assert.Equal(101, queue.Pump<MotionFrame>(frame => Assert.Equal(next++, frame.Values[0])));
    }

    [Fact]
    public async Task A_failure_of_the_writer_is_the_reason()
    {
        var pipe = new Pipe();
        await using var reader = new NeuronReader(pipe.Reader, SourceReaderTests.Options());
        reader.Start();
        await pipe.Writer.WriteAsync(TestPackets.Motion(1), TestContext.Current.CancellationToken);
        await reader.WaitForFramesAsync(1);
        await pipe.Writer.CompleteAsync(new IOException("The tunnel collapsed."));
        await reader.Completion.Soon();
        Assert.Equal((ConnectionReason.NetworkError, "Receiving from the pipe failed: The tunnel collapsed."), (reader.Status.Reason, reader.Status.Message));
    }

    [Fact]
    public async Task The_writer_waits_for_a_slow_handler()
    {
        var pipe = new Pipe(new PipeOptions(pauseWriterThreshold: 3000, resumeWriterThreshold: 1));
        await using var reader = new NeuronReader(pipe.Reader, SourceReaderTests.Options());
        using var leave = new SemaphoreSlim(0);
        reader.MotionReceived += _ => leave.Wait(Limits.Unexpected);
        reader.Start();
        await pipe.Writer.WriteAsync(TestPackets.Motion(0), TestContext.Current.CancellationToken);
        ValueTask<FlushResult> flush = pipe.Writer.WriteAsync(TestPackets.Motions(1, 2), TestContext.Current.CancellationToken);
        Assert.False(flush.IsCompleted);
        leave.Release(3);
        await flush.AsTask().Soon();
        await reader.WaitForFramesAsync(3);
    }

    [Fact]
    public async Task A_cancelled_read_of_others_does_not_end_the_reader()
    {
        var pipe = new Pipe();
        await using var reader = new NeuronReader(pipe.Reader, SourceReaderTests.Options());
        reader.Start();
        for (int i = 1; i <= 10; i++)
        {
            pipe.Reader.CancelPendingRead();
            await pipe.Writer.WriteAsync(TestPackets.Motion(i), TestContext.Current.CancellationToken);
            await reader.WaitForFramesAsync(i);
        }
    }

    [Theory]
    [InlineData(0)]
    [InlineData(700)]
    [InlineData(2000)]
    public async Task Stopped_while_a_read_waits(int bytes)
    {
        var pipe = new Pipe();
        var reader = new NeuronReader(pipe.Reader, SourceReaderTests.Options());
        await reader.StartAsync().Soon();
        if (bytes > 0)
            await pipe.Writer.WriteAsync(TestPackets.Motions(0, 2).AsMemory(0, bytes), TestContext.Current.CancellationToken);

        await reader.WaitForFramesAsync(bytes / 1480);
        reader.Dispose();
        await AssertStoppedAsync(reader);
        await AssertCompletedAsync(pipe);
    }

    [Fact]
    public async Task Stopped_before_the_start()
    {
        var pipe = new Pipe();
        var reader = new NeuronReader(pipe.Reader);
        reader.Dispose();
        await AssertStoppedAsync(reader);
        await AssertCompletedAsync(pipe);
    }

    [Fact]
    public async Task Stopped_from_a_handler()
    {
        var pipe = new Pipe();
        var reader = new NeuronReader(pipe.Reader, SourceReaderTests.Options());
        int frames = 0;
        reader.MotionReceived += _ =>
        {
            frames++;
            reader.Dispose();
        };
        reader.Start();
        await pipe.Writer.WriteAsync(TestPackets.Motions(0, 20), TestContext.Current.CancellationToken);
        await AssertStoppedAsync(reader);
        await AssertCompletedAsync(pipe);
        Assert.Equal(1, frames);
    }

    [Fact]
    public async Task Stopped_at_any_moment_of_a_start()
    {
        for (int round = 0; round < 100; round++)
        {
            var pipe = new Pipe();
            var reader = new NeuronReader(pipe.Reader, SourceReaderTests.Options());
            await pipe.Writer.WriteAsync(TestPackets.Motions(0, 20), TestContext.Current.CancellationToken);
            Task starting = Task.Run(reader.Start);
            Thread.SpinWait(round * 50);
            await reader.DisposeAsync();
            await starting.ContinueWith(static _ => { }, TaskScheduler.Default).Soon();
            await AssertStoppedAsync(reader);
            await AssertCompletedAsync(pipe);
        }
    }

    [Fact]
    public async Task Stopped_while_a_pipe_never_answers()
    {
        var reader = new NeuronReader(new StuckPipe(), SourceReaderTests.Options());
        await reader.StartAsync().Soon();
        reader.Dispose();
        await AssertStoppedAsync(reader);
    }

    [Fact]
    public async Task Pipes_of_a_source_are_opened_again()
    {
        var pipes = new Queue<Pipe?>([new Pipe(), null, new Pipe()]);
        Pipe[] all = [.. pipes.OfType<Pipe>()];
        ByteSource source = ByteSource.FromPipes(
            async token =>
            {
                if (!pipes.TryDequeue(out Pipe? next))
                    await Task.Delay(Timeout.Infinite, token);

                return next?.Reader!;
            },
            "the tunnels");
        await using var reader = new NeuronReader(SourceReaderTests.Options(source: source));
        var log = new StatusLog(reader);
        reader.Start();
        await all[0].Writer.WriteAsync(TestPackets.Motion(1), TestContext.Current.CancellationToken);
        await reader.WaitForFramesAsync(1);
        await all[0].Writer.CompleteAsync(new IOException("It collapsed."));
        await all[1].Writer.WriteAsync(TestPackets.Motion(2), TestContext.Current.CancellationToken);
        await reader.WaitForFramesAsync(2);
        reader.Dispose();
        await AssertStoppedAsync(reader);
        await AssertCompletedAsync(all[0]);
        await AssertCompletedAsync(all[1]);
        Assert.Equal(
            ["Receiving from the tunnels failed: It collapsed.", "Opening the tunnels failed: The source returned no pipe."],
            log.All.Where(static status => status.State == ConnectionState.Waiting).Select(static status => status.Message));
    }

    [Fact]
    public async Task A_pipe_of_a_source_is_diagnosed()
    {
        var pipe = new Pipe();
        await pipe.Writer.WriteAsync(TestPackets.Motions(0, 20), TestContext.Current.CancellationToken);
        StreamDiagnosis diagnosis = await Diagnosing.RunAsync(
            new NeuronReaderOptions { Source = ByteSource.FromPipes(_ => new ValueTask<PipeReader>(pipe.Reader)) }, Diagnosing.With(Diagnosing.Patient));
        Assert.True(diagnosis.IsReceiving);
        await AssertCompletedAsync(pipe);
    }

    // What a caller of OpenAsync gets, for whom the source is one of streams.
    [Fact]
    public async Task A_pipe_of_a_source_is_a_stream_for_others()
    {
        var pipe = new Pipe();
        await pipe.Writer.WriteAsync(TestPackets.Motion(1), TestContext.Current.CancellationToken);
        await pipe.Writer.CompleteAsync();
        await using Stream stream = await ByteSource.FromPipes(_ => new ValueTask<PipeReader>(pipe.Reader)).OpenAsync(TestContext.Current.CancellationToken);
        using var bytes = new MemoryStream();
        await stream.CopyToAsync(bytes, TestContext.Current.CancellationToken);
        Assert.Equal(TestPackets.Motion(1), bytes.ToArray());
    }

    [Fact]
    public void A_source_of_pipes_needs_a_function_and_a_name()
    {
        Assert.Throws<ArgumentNullException>("open", () => ByteSource.FromPipes(null!));
        Assert.Throws<ArgumentException>("name", () => ByteSource.FromPipes(static _ => default, " "));
    }

    [Fact]
    public void A_pipe_is_required() => Assert.Throws<ArgumentNullException>("pipe", () => new NeuronReader((PipeReader)null!));

    private static async Task AssertStoppedAsync(NeuronReader reader)
    {
        await reader.Completion.Soon();
        Assert.Equal((ConnectionState.Stopped, ConnectionReason.Requested), (reader.Status.State, reader.Status.Reason));
    }

    // A pending read can end a moment later.
    private static async Task AssertCompletedAsync(Pipe pipe)
    {
        while (!(await pipe.Writer.FlushAsync(TestContext.Current.CancellationToken).Soon()).IsCompleted)
            await Task.Delay(1, TestContext.Current.CancellationToken);
    }

    private sealed class StuckPipe : PipeReader
    {
        public override void AdvanceTo(SequencePosition consumed)
        {
        }

        public override void AdvanceTo(SequencePosition consumed, SequencePosition examined)
        {
        }

        public override void CancelPendingRead()
        {
        }

        public override void Complete(Exception? exception = null)
        {
        }

        public override ValueTask<ReadResult> ReadAsync(CancellationToken cancellationToken = default) => new(new TaskCompletionSource<ReadResult>().Task);

        public override bool TryRead(out ReadResult result)
        {
            result = default;
            return false;
        }
    }
}
