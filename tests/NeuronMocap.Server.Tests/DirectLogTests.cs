using NeuronMocap.Server.Broadcasting;

namespace NeuronMocap.Server.Tests;

// Units that the writer of a log hands to recipients without a change of threads.
public sealed class DirectLogTests
{
    private readonly FrameLog _log = new(length: 4);
    private readonly byte[] _buffer = new byte[100];

    [Fact]
    public async Task A_reader_that_waits_gets_units_without_waking()
    {
        (FrameCursor cursor, Recipient recipient) = CreateReader();
        Task<FrameBatch> reading = await ReadAsync(cursor);
        _log.Publish(Units(1, 2));
        _log.Publish(Units(3));
        Assert.Equal([1, 1, 2, 2, 3, 3], recipient.Taken);
        Assert.False(reading.IsCompleted);
        Assert.Equal(0, _log.GetMissed(cursor));
        _log.Wake(cursor);
        Assert.Equal(default, await reading.Soon());
    }

    [Fact]
    public async Task A_reader_that_takes_only_a_part_continues_with_the_rest()
    {
        (FrameCursor cursor, Recipient recipient) = CreateReader();
        Task<FrameBatch> reading = await ReadAsync(cursor);
        recipient.Room = 1;
        _log.Publish(Units(1, 2, 3));
        Assert.Equal(new FrameBatch(4, 2), await reading.Soon());
        Assert.Equal([2, 2, 3, 3], _buffer[..4]);
        Assert.Equal([1, 1], recipient.Taken);

        // It does not wait now, so its own thread gets the next unit.
        _log.Publish(Units(4));
        Assert.Equal(new FrameBatch(2, 1), _log.Read(cursor, _buffer));
        Assert.Equal([1, 1], recipient.Taken);
    }

    [Fact]
    public async Task A_recipient_that_is_not_ready_wakes_even_if_it_took_everything()
    {
        (FrameCursor cursor, Recipient recipient) = CreateReader();
        Task<FrameBatch> reading = await ReadAsync(cursor);
        recipient.IsReady = false;
        _log.Publish(Units(1));
        Assert.Equal(default, await reading.Soon());
        Assert.Equal([1, 1], recipient.Taken);
    }

    [Fact]
    public async Task A_slow_reader_beside_a_direct_one_gets_the_same_units_and_counts_its_own_losses()
    {
        (FrameCursor cursor, Recipient recipient) = CreateReader();
        FrameCursor slow = _log.CreateCursor();
        await ReadAsync(cursor);
        _log.Publish(Units(1, 2));
        Assert.Equal(new FrameBatch(4, 2), _log.Read(slow, _buffer.AsSpan(50)));
        _log.Publish(Units(3, 4, 5, 6, 7, 8));
        Assert.Equal((2L, 0L), (_log.GetMissed(slow), _log.GetMissed(cursor)));
        Assert.Equal(new FrameBatch(8, 4), _log.Read(slow, _buffer.AsSpan(50)));
        Assert.Equal([5, 5, 6, 6, 7, 7, 8, 8], _buffer[50..58]);
        Assert.Equal(16, recipient.Taken.Count);
        _log.Abort();
    }

    [Fact]
    public async Task A_reader_that_comes_after_units_that_nobody_stored_starts_at_the_next_one()
    {
        (FrameCursor cursor, _) = CreateReader();
        await ReadAsync(cursor);
        _log.Publish(Units(1, 2, 3));
        FrameCursor late = _log.CreateCursor();
        _log.Publish(Units(4));
        Assert.Equal(new FrameBatch(2, 1), _log.Read(late, _buffer.AsSpan(50)));
        Assert.Equal(4, _buffer[50]);
        _log.Abort();
    }

    [Fact]
    public async Task Only_so_many_readers_are_direct()
    {
        (FrameCursor Cursor, Recipient Recipient)[] readers = [.. Enumerable.Range(0, 17).Select(_ => CreateReader())];
        List<Task<FrameBatch>> reading = [];
        foreach ((FrameCursor cursor, _) in readers)
            reading.Add(await ReadAsync(cursor, new byte[10]));

        _log.Publish(Units(1));
        Assert.All(readers[..16], static reader => Assert.Equal([1, 1], reader.Recipient.Taken));
        Assert.Empty(readers[16].Recipient.Taken);
        Assert.Equal(new FrameBatch(2, 1), await reading[16].Soon());
        _log.Abort();
        await Task.WhenAll(reading).Soon();
    }

    [Fact]
    public async Task A_recipient_that_throws_goes_on_with_its_own_thread_and_costs_the_others_nothing()
    {
        (FrameCursor cursor, Recipient recipient) = CreateReader();
        (FrameCursor failing, Recipient thrower) = CreateReader();
        (FrameCursor last, Recipient later) = CreateReader();
        thrower.Fault = new InvalidOperationException();
        byte[] buffer = new byte[100];
        await ReadAsync(cursor);
        Task<FrameBatch> reading = await ReadAsync(failing, buffer);
        await ReadAsync(last, new byte[100]);
        _log.Publish(Units(1, 2));
        Assert.Equal(new FrameBatch(4, 2), await reading.Soon());
        Assert.Equal([1, 1, 2, 2], buffer[..4]);

        reading = await ReadAsync(failing, buffer);
        _log.Publish(Units(3));
        Assert.Equal(new FrameBatch(2, 1), await reading.Soon());
        Assert.Equal([1, 1, 2, 2, 3, 3], recipient.Taken);
        Assert.Equal([1, 1, 2, 2, 3, 3], later.Taken);
        Assert.Equal((0L, 0L, 0L), (_log.GetMissed(cursor), _log.GetMissed(failing), _log.GetMissed(last)));
        _log.Abort();
    }

    [Fact]
    public async Task The_end_wakes_a_direct_reader_that_has_everything()
    {
        (FrameCursor cursor, _) = CreateReader();
        Task<FrameBatch> reading = await ReadAsync(cursor);
        _log.Publish(Units(1));
        _log.Complete();
        Assert.Equal(default, await reading.Soon());
        Assert.True(_log.IsAtEnd(cursor));
    }

    [Fact]
    public async Task A_reader_that_waits_gets_frames_and_their_packets_without_waking()
    {
        var log = new FrameLog(length: 4, packetsPerFrame: 2);
        FrameCursor cursor = log.CreateCursor();
        var recipient = new Recipient();
        log.Attach(cursor, recipient);
        Task<FrameBatch> reading = await ReadAsync(cursor, log: log);
        log.Publish([1, 2]);
        log.Publish([3], packets: 1);
        FrameCursor late = log.CreateCursor();
        log.Publish([4], packets: 1);
        Assert.Equal([1, 2, 3, 4], recipient.Taken);
        Assert.Equal([(2, 0), (1, 0), (1, 1)], recipient.Parts);
        Assert.False(reading.IsCompleted);

        // It has the first packet of a frame, then wakes, and its own thread reads the second.
        log.Publish([5], packets: 1);
        log.Wake(cursor);
        Assert.Equal(new FrameBatch(0, 0, First: 1), await reading.Soon());
        log.Publish([6], packets: 1);
        Assert.Equal(new FrameBatch(1, 1, First: 1), log.Read(cursor, _buffer));
        Assert.Equal(6, _buffer[0]);
        Assert.Equal(0, log.GetMissed(cursor));

        Assert.Equal(new FrameBatch(4, 4), log.Read(late, _buffer));
        Assert.Equal([3, 4, 5, 6], _buffer[..4]);
    }

    [Fact]
    public async Task Whole_frames_of_several_packets_pass_at_once_and_stay_for_others()
    {
        var log = new FrameLog(length: 4, packetsPerFrame: 2);
        FrameCursor cursor = log.CreateCursor();
        var recipient = new Recipient();
        log.Attach(cursor, recipient);
        FrameCursor other = log.CreateCursor();
        Task<FrameBatch> reading = await ReadAsync(cursor, log: log);
        log.Publish(Units(1));
        log.Publish(Units(2));
        Assert.Equal([1, 1, 2, 2], recipient.Taken);
        Assert.Equal([(2, 0), (2, 0)], recipient.Parts);
        Assert.False(reading.IsCompleted);
        Assert.Equal(new FrameBatch(4, 4), log.Read(other, _buffer));
        Assert.Equal([1, 1, 2, 2], _buffer[..4]);
        log.Abort();
    }

    [Fact]
    public async Task A_reader_without_room_reads_the_frame_on_its_own_thread()
    {
        var log = new FrameLog(length: 4, packetsPerFrame: 2);
        FrameCursor cursor = log.CreateCursor();
        var recipient = new Recipient { Room = 0 };
        log.Attach(cursor, recipient);
        Task<FrameBatch> reading = await ReadAsync(cursor, log: log);
        log.Publish([1, 2]);
        Assert.Equal(new FrameBatch(2, 2), await reading.Soon());
        Assert.Equal([1, 2], _buffer[..2]);
        Assert.Empty(recipient.Taken);
        Assert.Equal(0, log.GetMissed(cursor));
    }

    private static UnitBatch Units(params byte[] units)
    {
        var batch = new UnitBatch();
        foreach (byte unit in units)
        {
            batch.Append([unit, unit]);
            batch.Cut(TimeSpan.Zero, isCalculation: false);
        }

        return batch;
    }

    private (FrameCursor Cursor, Recipient Recipient) CreateReader()
    {
        FrameCursor cursor = _log.CreateCursor();
        var recipient = new Recipient();
        _log.Attach(cursor, recipient);
        return (cursor, recipient);
    }

    // Returns when the reader waits.
    private async Task<Task<FrameBatch>> ReadAsync(FrameCursor cursor, byte[]? buffer = null, FrameLog? log = null)
    {
        Task<FrameBatch> reading = Task.Factory.StartNew(
            () => (log ?? _log).Read(cursor, buffer ?? _buffer), TestContext.Current.CancellationToken, TaskCreationOptions.LongRunning, TaskScheduler.Default);
        await Limits.UntilAsync(() => cursor.IsWaiting);
        return reading;
    }

    private sealed class Recipient : IDirectRecipient
    {
        public List<byte> Taken { get; } = [];

        // Packets and first packet of each call.
        public List<(int Packets, int First)> Parts { get; } = [];

        public int Room { get; set; } = int.MaxValue;

        public bool IsReady { get; set; } = true;

        public Exception? Fault { get; set; }

        public int Take(UnitBatch units, int packets, int first)
        {
            if (Fault is not null)
                throw Fault;

            Parts.Add((packets, first));
            int count = Math.Min(units.Count, Room);
            for (int i = 0; i < count; i++)
                Taken.AddRange(units.BytesOf(i));

            return count;
        }
    }
}
