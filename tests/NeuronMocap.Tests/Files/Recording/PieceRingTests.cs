using NeuronMocap.Recording;

namespace NeuronMocap.Tests.Recording;

// The queue between the receive thread and the thread that writes, without either.
public sealed class PieceRingTests
{
    private const int Capacity = 1 << 20;
    private const int Part = Capacity / 8;

    private static readonly byte[] Piece = [.. Enumerable.Range(0, 1480).Select(static i => (byte)i)];

    [Theory]
    [InlineData(0)]
    [InlineData(Part - 8)]
    [InlineData(Capacity - 800)]
    [InlineData(int.MaxValue - 799)]
    public async Task A_consumer_that_waits_wakes_before_two_parts_wait(int firstIndex)
    {
        var ring = new PieceRing(Capacity, firstIndex);
        for (int round = 0; round < 3; round++)
        {
            Task waiting = Task.Factory.StartNew(
                () => ring.Wait(Timeout.InfiniteTimeSpan), TestContext.Current.CancellationToken, TaskCreationOptions.LongRunning, TaskScheduler.Default);
            int written = 0;
            for (; written < 2 * Part; written += PieceRecord.SizeOf(Piece.Length))
                Assert.True(ring.TryWrite(new PieceRecord { Kind = PieceKind.Bytes }, [], Piece));

            await waiting.Soon();
            Assert.Equal(written, ReadAll(ring) * PieceRecord.SizeOf(Piece.Length));
        }
    }

    [Theory]
    [InlineData(0)]
    [InlineData(-24)]
    [InlineData(-48)]
    [InlineData(-56)]
    [InlineData(-808)]
    public void A_record_that_continues_at_the_start_of_the_ring_is_whole(int firstIndex)
    {
        var ring = new PieceRing(Capacity, firstIndex);
        Assert.True(ring.TryWrite(new PieceRecord { Kind = PieceKind.Bytes, Connection = 3, Timestamp = 4 }, [1, 2, 3], Piece));
        Assert.True(ring.TryPeek(out PieceRecord record));
        Assert.Equal((PieceKind.Bytes, 3, 4L), (record.Kind, record.Connection, record.Timestamp));
        Assert.Equal([1, 2, 3, .. Piece], ring.Peek(record).ToArray());
        ring.Release(record);
        Assert.False(ring.TryPeek(out _));
    }

    private static int ReadAll(PieceRing ring)
    {
        int count = 0;
        for (; ring.TryPeek(out PieceRecord record); count++)
        {
            Assert.True(ring.Peek(record).SequenceEqual(Piece));
            ring.Release(record);
        }

        return count;
    }
}
