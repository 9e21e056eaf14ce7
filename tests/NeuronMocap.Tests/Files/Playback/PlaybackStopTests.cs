using NeuronMocap.Recording;

namespace NeuronMocap.Tests.Playback;

// Ending a playback does not wait for a place that takes long to find.
public sealed class PlaybackStopTests
{
    [Theory, InlineData(true), InlineData(false)]
    public async Task Stopping_ends_a_long_seek(bool disposesPlayer)
    {
        var source = new EndlessSource();
        using var player = new RecordingPlayer(source, new PlaybackOptions());
        await using var reader = new NeuronReader(player);
        player.Pause();
        player.Seek(TimeSpan.FromMinutes(30));
        reader.Start();
        await Limits.UntilAsync(() => source.Reads > 1000);

        if (disposesPlayer)
            player.Dispose();
        else
            await reader.DisposeAsync();

        await reader.Completion.Soon();
        await Limits.UntilAsync(() => !source.IsReading);
    }

    // The playback's thread waits in a full queue. At MaxSpeed it waits for every queue.
    [Theory]
    [InlineData(1, WhenFull.Wait)]
    [InlineData(RecordingPlayer.MaxSpeed, WhenFull.Wait)]
    [InlineData(RecordingPlayer.MaxSpeed, WhenFull.DropNewest)]
    public async Task Disposing_the_player_ends_the_wait_for_a_queue(double speed, WhenFull whenFull)
    {
        using TemporaryFile file = Played.Frames(10, interval: 0, perPiece: 10);
        using RecordingPlayer player = RecordingPlayer.Open(file.Path);
        player.Speed = speed;
        await using var reader = new NeuronReader(player);
        using FrameQueue queue = reader.OpenQueue(new FrameQueueOptions { Capacity = 2, WhenFull = whenFull });
        reader.Start();
        await Limits.UntilAsync(() => reader.GetStatistics().MotionFrames == 3 && reader.IsDelivering);

        player.Dispose();
        await reader.Completion.Soon();
        Assert.Equal((0, 2), (queue.Delivered, queue.Count));
        Assert.Equal(reader.GetStatistics().Frames, queue.Dropped + queue.Count);
    }

    // The stop does not wait for the thread that it runs on, so it is complete at once.
    [Theory, InlineData(false), InlineData(true)]
    public async Task The_end_can_stop_the_reader_at_once(bool fails)
    {
        using TemporaryFile file = Played.TenFrames();
        using RecordingPlayer player = Played.Open(file, new FakeTime());
        await using var reader = new NeuronReader(player, new NeuronReaderOptions { StopTimeout = Limits.Unexpected });
        bool? isStopped = null;
        if (fails)
        {
            reader.CallbackFailed += _ => Stop();
            player.Completed += static () => throw new InvalidOperationException();
        }
        else
        {
            player.Completed += Stop;
        }

        reader.Start();
        await reader.Completion.Soon();
        Assert.True(isStopped);

        void Stop() => isStopped = reader.DisposeAsync().AsTask().IsCompleted;
    }

    // Contains only the instant zero, without end.
    private sealed class EndlessSource() : RecordedEventSource("endless")
    {
        private readonly byte[] _bytes = new byte[8];
        private long _reads;
        private long _lastRead;

        public long Reads => Interlocked.Read(ref _reads);

        // Whether it was read since the last call.
        public bool IsReading
        {
            get
            {
                long reads = Reads;
                bool isReading = reads != _lastRead;
                _lastRead = reads;
                return isReading;
            }
        }

        public override TimeSpan Duration => TimeSpan.FromHours(1);

        public override RecordedEvent Read() => Interlocked.Increment(ref _reads) == 1
            ? new RecordedEvent(RecordedEventKind.Opened, TimeSpan.Zero)
            : new RecordedEvent(RecordedEventKind.Bytes, TimeSpan.Zero) { Bytes = new ArraySegment<byte>(_bytes) };

        public override bool Seek(TimeSpan time) => true;

        public override void Dispose()
        {
        }
    }
}
