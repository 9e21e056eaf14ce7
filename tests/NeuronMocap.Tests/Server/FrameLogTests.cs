using NeuronMocap.Server.Broadcasting;

namespace NeuronMocap.Tests.Server;

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
    public void A_reader_that_falls_behind_loses_the_oldest_frames_and_they_are_counted_at_once(byte frames, int missed)
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
    public void After_the_end_readers_get_what_is_left_and_then_nothing()
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
    public async Task Waiting_readers_are_woken_by_a_frame_and_sent_away_by_an_abort()
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
    public void Frames_may_differ_in_length_and_slots_are_used_again()
    {
        FrameCursor cursor = _log.CreateCursor();
        for (int length = 1; length < 40; length++)
        {
            int second = (length / 2) + 1;
            _log.Publish(Frame(length));
            _log.Publish(Frame(second));

            // There is room for both but for one byte.
            Assert.Equal(new FrameBatch(length, 1), _log.Read(cursor, _buffer.AsSpan(0, length + second - 1)));
            Assert.Equal(Frame(length), _buffer[..length]);
            Assert.Equal(new FrameBatch(second, 1), _log.Read(cursor, _buffer));
            Assert.Equal(Frame(second), _buffer[..second]);
        }

        static byte[] Frame(int length) => [.. Enumerable.Range(0, length).Select(i => (byte)(i + length))];
    }

    [Fact]
    public async Task A_woken_reader_gets_nothing_and_the_others_wait_on()
    {
        FrameCursor cursor = _log.CreateCursor();
        FrameCursor other = _log.CreateCursor();
        Task<FrameBatch> waiting = Task.Run(() => _log.Read(other, new byte[100]), TestContext.Current.CancellationToken);
        _log.Wake(cursor);
        Assert.Equal(default, _log.Read(cursor, _buffer));
        Assert.False(_log.IsOver(cursor));

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
