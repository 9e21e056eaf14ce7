using NeuronMocap.Server.Broadcasting;

namespace NeuronMocap.Server.Tests;

public sealed class FrameLogTests
{
    private readonly FrameLog _log = new(length: 4);
    private readonly byte[] _buffer = new byte[100];

    [Fact]
    public void A_reader_starts_at_the_next_frame_and_gets_whole_frames_that_fit()
    {
        Publish(1);
        FrameCursor cursor = _log.CreateCursor();
        Publish(2, 3, 4);

        Assert.Equal(4, _log.Read(cursor, _buffer.AsSpan(0, 5)).Bytes);
        Assert.Equal([2, 2, 3, 3], _buffer[..4]);
        Assert.Equal(2, _log.Read(cursor, _buffer).Bytes);
        Assert.Equal([4, 4], _buffer[..2]);
        Assert.Equal(0, _log.GetMissed(cursor));
    }

    [Theory]
    [InlineData(4, 0)]
    [InlineData(5, 1)]
    [InlineData(11, 7)]
    public void A_slow_reader_loses_the_oldest_frames_which_are_counted_at_once(byte frames, int missed)
    {
        FrameCursor cursor = _log.CreateCursor();
        for (byte i = 1; i <= frames; i++)
            Publish(i);

        Assert.Equal(missed, _log.GetMissed(cursor));
        Assert.Equal(8, _log.Read(cursor, _buffer).Bytes);
        Assert.Equal((byte)(missed + 1), _buffer[0]);
        Assert.Equal(frames, _buffer[7]);
        Assert.Equal(missed, _log.GetMissed(cursor));
    }

    [Fact]
    public void A_frame_may_appear_packet_by_packet()
    {
        var log = new FrameLog(length: 4, packetsPerFrame: 3);
        FrameCursor cursor = log.CreateCursor();
        log.Publish([1], packets: 1);
        Assert.Equal(new FrameBatch(1, 1), log.Read(cursor, _buffer));
        FrameCursor late = log.CreateCursor();
        log.Publish([2, 2], packets: 1);
        Assert.Equal(new FrameBatch(2, 1, First: 1), log.Read(cursor, _buffer));
        log.Publish([3], packets: 1);
        log.Publish([4, 5, 6]);
        log.Publish([7], packets: 1);
        Assert.Equal(new FrameBatch(5, 5, First: 2), log.Read(cursor, _buffer));
        Assert.Equal([3, 4, 5, 6, 7], _buffer[..5]);

        // A reader that came in the middle of a frame gets all of it.
        Assert.Equal(new FrameBatch(8, 7), log.Read(late, _buffer));
        Assert.Equal([1, 2, 2, 3, 4, 5, 6, 7], _buffer[..8]);
        Assert.Equal((0L, 0L), (log.GetMissed(cursor), log.GetMissed(late)));
    }

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(5)]
    public void A_reader_that_falls_behind_within_a_frame_resumes_at_a_frame_and_counts_the_loss(int length)
    {
        const int Frames = 10;
        var log = new FrameLog(length, packetsPerFrame: 3);
        FrameCursor cursor = log.CreateCursor();
        log.Publish([0], packets: 1);
        Assert.Equal(new FrameBatch(1, 1), log.Read(cursor, _buffer));
        for (byte packet = 1; packet < 3 * Frames; packet++)
            log.Publish([packet], packets: 1);

        // The newest frame replaces the oldest.
        log.Publish([3 * Frames], packets: 1);
        int first = 3 * (Frames + 1 - length);
        Assert.Equal(first - 1, log.GetMissed(cursor));
        Assert.Equal(new FrameBatch((3 * Frames) + 1 - first, (3 * Frames) + 1 - first), log.Read(cursor, _buffer));
        Assert.Equal(first, _buffer[0]);
        Assert.Equal(first - 1, log.GetMissed(cursor));
    }

    [Fact]
    public void Readers_get_the_remaining_frames_after_the_end()
    {
        FrameCursor cursor = _log.CreateCursor();
        Publish(1);
        _log.Complete();

        Assert.False(_log.IsAtEnd(cursor));
        Assert.Equal(2, _log.Read(cursor, _buffer).Bytes);
        Assert.True(_log.IsAtEnd(cursor));
        Assert.Equal(0, _log.Read(cursor, _buffer).Bytes);
    }

    [Fact]
    public async Task Waiting_readers_wake_on_a_frame_and_on_an_abort()
    {
        FrameCursor cursor = _log.CreateCursor();
        Task<FrameBatch> reading = Task.Run(() => _log.Read(cursor, _buffer), TestContext.Current.CancellationToken);
        Publish(1);
        Assert.Equal(new FrameBatch(2, 1), await reading.Soon());

        reading = Task.Run(() => _log.Read(cursor, _buffer), TestContext.Current.CancellationToken);
        _log.Abort();
        Assert.Equal(default, await reading.Soon());
        Assert.False(_log.IsAtEnd(cursor));
    }

    [Fact]
    public void Slots_are_reused_for_frames_of_any_length()
    {
        FrameCursor cursor = _log.CreateCursor();
        for (int length = 1; length < 40; length++)
        {
            int second = (length / 2) + 1;
            _log.Publish(Frame(length));
            _log.Publish(Frame(second));

            // There is room for both except for one byte.
            Assert.Equal(new FrameBatch(length, 1), _log.Read(cursor, _buffer.AsSpan(0, length + second - 1)));
            Assert.Equal(Frame(length), _buffer[..length]);
            Assert.Equal(new FrameBatch(second, 1), _log.Read(cursor, _buffer));
            Assert.Equal(Frame(second), _buffer[..second]);
        }

        static byte[] Frame(int length) => [.. Enumerable.Range(0, length).Select(i => (byte)(i + length))];
    }

    [Fact]
    public async Task Waking_one_reader_leaves_the_others_waiting()
    {
        FrameCursor cursor = _log.CreateCursor();
        FrameCursor other = _log.CreateCursor();
        Task<FrameBatch> waiting = Task.Run(() => _log.Read(other, new byte[100]), TestContext.Current.CancellationToken);
        _log.Wake(cursor);
        Assert.Equal(default, _log.Read(cursor, _buffer));
        Assert.False(_log.HasEnded(cursor));

        Task<FrameBatch> reading = Task.Run(() => _log.Read(cursor, _buffer), TestContext.Current.CancellationToken);
        _log.Wake(cursor);
        Assert.Equal(default, await reading.Soon());
        Assert.False(waiting.IsCompleted);
        Publish(1);
        Assert.Equal(new FrameBatch(2, 1), await waiting.Soon());
        Assert.Equal(new FrameBatch(2, 1), _log.Read(cursor, _buffer));
    }

    private void Publish(params byte[] frames)
    {
        foreach (byte frame in frames)
            _log.Publish([frame, frame]);
    }
}
