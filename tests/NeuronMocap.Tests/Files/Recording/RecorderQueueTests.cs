using System.Diagnostics;
using System.Net;
using NeuronMocap.Protocol;
using NeuronMocap.Recording;

namespace NeuronMocap.Tests.Recording;

// The recorder's queue on a slow disk.
public sealed class RecorderQueueTests : RecorderTest
{
    [Fact]
    public async Task Dropped_pieces_are_counted_and_recorded_in_place()
    {
        var disk = new HeldStream();
        StreamRecorder recorder = Start(new RecordingOptions { QueueSize = 1 << 20 }, disk);
        for (int i = 0; i < 3; i++)
        {
            await LoseAsync(recorder, disk, pieces: 100);
            disk.LetGo();
            await PushUntilTakenAsync(recorder);
        }

        recorder.Dispose();
        List<RecordedEntry> entries = RecordedEntry.ReadAll(disk.ToArray());
        RecordingStatistics statistics = recorder.GetStatistics();
        RecordedEntry[] losses = [.. entries.Where(entry => entry.Kind == RecordingEntryKind.BytesLost)];
        Assert.InRange(losses.Length, 3, int.MaxValue);
        Assert.Equal(statistics.LostPieces, losses.Sum(loss => loss.LostPieces));
        Assert.Equal((statistics.LostPieces * PieceSize, statistics.LostBytes), (losses.Sum(loss => loss.LostBytes), losses.Sum(loss => loss.LostBytes)));
        Assert.Equal(Sent, statistics.Pieces + statistics.LostPieces);

        // A loss stands for exactly the pieces between its neighbours.
        long expected = 0;
        foreach (RecordedEntry entry in entries)
        {
            if (entry.Kind == RecordingEntryKind.BytesLost)
                expected += entry.LostPieces;
            else if (entry.Kind == RecordingEntryKind.Bytes)
                Assert.Equal(expected++, BitConverter.ToInt32(Convert.FromHexString(entry.Bytes)));
        }

        Assert.Equal(Sent, expected);
    }

    [Fact]
    public async Task Losses_at_the_end_are_recorded()
    {
        var disk = new HeldStream();
        StreamRecorder recorder = Start(new RecordingOptions { QueueSize = 1 << 20 }, disk);
        await LoseAsync(recorder, disk, pieces: 10);
        recorder.Stop();
        disk.LetGo();
        await recorder.Completion.Soon();
        using RecordingReader reader = RecordingReader.Open(new MemoryStream(disk.ToArray()));
        Assert.Equal(new RecordingTotals(Sent - 10, (Sent - 10) * PieceSize, 10, 10 * PieceSize), reader.Totals);
    }

    [Fact]
    public async Task Connection_events_have_reserved_room()
    {
        var disk = new HeldStream();
        StreamRecorder recorder = Start(new RecordingOptions { QueueSize = 1 << 20 }, disk);
        await LoseAsync(recorder, disk, pieces: 10);
        Reconnect(times: 50);

        disk.LetGo();
        recorder.Dispose();
        List<RecordedEntry> entries = RecordedEntry.ReadAll(disk.ToArray());
        Assert.Equal(Enumerable.Range(0, 51), entries.Where(entry => entry.Kind == RecordingEntryKind.ConnectionOpened).Select(entry => entry.Connection));
        Assert.Equal(Enumerable.Range(0, 50), entries.Where(entry => entry.Kind == RecordingEntryKind.ConnectionClosed).Select(entry => entry.Connection));
        RecordedEntry loss = Assert.Single(entries, entry => entry.Kind == RecordingEntryKind.BytesLost);
        Assert.Equal((0, 10L), (loss.Connection, loss.LostPieces));
    }

    [Fact]
    public async Task A_dropped_opening_is_recorded_with_the_first_piece()
    {
        var disk = new HeldStream();
        StreamRecorder recorder = Start(new RecordingOptions { QueueSize = 1 << 20 }, disk);
        await LoseAsync(recorder, disk, pieces: 10);
        Reconnect(times: 1000);

        disk.LetGo();
        await PushUntilTakenAsync(recorder);
        recorder.Dispose();
        Assert.Null(recorder.Failure);
        List<RecordedEntry> entries = RecordedEntry.ReadAll(disk.ToArray());
        int open = -1;
        foreach (RecordedEntry entry in entries)
        {
            if (entry.Kind == RecordingEntryKind.ConnectionOpened)
            {
                Assert.Equal(-1, open);
                open = entry.Connection;
            }
            else if (entry.Kind == RecordingEntryKind.ConnectionClosed)
            {
                Assert.Equal(open, entry.Connection);
                open = -1;
            }
            else if (entry.Kind == RecordingEntryKind.Bytes)
            {
                Assert.Equal(open, entry.Connection);
            }
        }

        Assert.Equal(1000, open);
    }

    [Fact]
    public void A_failed_start_leaves_no_file_open()
    {
        var tap = new StreamTap();
        tap.Open(isDatagrams: false, new UnreadableEndPoint(), remote: null, timestamp: 0);
        var file = new MemoryStream();
        Assert.Throws<NotSupportedException>(() => new StreamRecorder(
            Folder.PathOf("take.nmrec"), new RecordingOptions(), RecordingMetadata.Empty, tap, static _ => { }, (_, _) => file));
        Assert.False(file.CanWrite);
        Assert.False(tap.IsListened);
    }

    [Fact]
    public async Task A_recording_ends_without_blocking_and_the_wait_can_be_cancelled()
    {
        var disk = new HeldStream();
        StreamRecorder recorder = Start(new RecordingOptions { FlushInterval = TimeSpan.FromSeconds(0.01) }, disk);
        disk.Hold();
        Push();
        using var cancelled = new CancellationTokenSource();
        Task stopped = recorder.StopAsync(cancelled.Token);
        Task disposed = recorder.DisposeAsync().AsTask();
        Assert.False(stopped.IsCompleted);
        await cancelled.CancelAsync();
        await Assert.ThrowsAnyAsync<OperationCanceledException>(() => stopped.Soon());
        Assert.False(disposed.IsCompleted);
        disk.LetGo();
        await recorder.StopAsync(TestContext.Current.CancellationToken).Soon();
        await disposed.Soon();
        Assert.Single(RecordedEntry.ReadAll(disk.ToArray()), entry => entry.Kind == RecordingEntryKind.Bytes);
    }

    [Fact]
    public void A_piece_allocates_nothing_on_the_receive_thread()
    {
        byte[] sender = new byte[16];
        sender[0] = 2;
        var disk = new HeldStream();
        StreamRecorder recorder = Start(new RecordingOptions { QueueSize = 1 << 24 }, disk);
        byte[] datagram = new byte[784];
        Allocations.AssertNone(() => Tap.OnBytes(7, sender, new ArraySegment<byte>(datagram), Stopwatch.GetTimestamp()));
        recorder.Dispose();
        Assert.Equal(0, recorder.GetStatistics().LostPieces);
        Allocations.AssertNone(() => Tap.OnBytes(7, sender, new ArraySegment<byte>(datagram), Stopwatch.GetTimestamp()));
    }

    [Fact]
    public async Task Pieces_reach_the_file_before_the_end()
    {
        StreamRecorder recorder = new(
            Folder.PathOf("take.nmrec"), new RecordingOptions { FlushInterval = TimeSpan.FromSeconds(0.01) }, RecordingMetadata.Empty, Tap, static _ => { });
        Push();
        await Limits.UntilAsync(() =>
        {
            using RecordingReader reader = RecordingReader.Open(Folder.PathOf("take.nmrec"));
            Assert.False(reader.IsComplete);
            return RecordedEntry.ReadAll(reader).Exists(entry => entry.Kind == RecordingEntryKind.Bytes);
        });
        recorder.Dispose();
    }

    // The disk takes nothing from here on. While the writing thread waits for it, no piece leaves the queue.
    private async Task LoseAsync(StreamRecorder recorder, HeldStream disk, int pieces)
    {
        const int Some = 200;
        disk.Hold();
        for (int i = 0; i < Some; i++)
            Push();

        await Limits.UntilAsync(() => disk.IsWaitedFor);
        long lost = recorder.GetStatistics().LostPieces;
        while (recorder.GetStatistics().LostPieces < lost + pieces)
            Push();
    }

    // Pushes until one piece fits into the queue.
    private Task PushUntilTakenAsync(StreamRecorder recorder) => Limits.UntilAsync(() =>
    {
        long lost = recorder.GetStatistics().LostPieces;
        Push();
        return recorder.GetStatistics().LostPieces == lost;
    });

    private void Reconnect(int times)
    {
        for (int i = 0; i < times; i++)
        {
            Tap.Close("Reset", Stopwatch.GetTimestamp());
            Tap.Open(isDatagrams: false, Local, Remote, Stopwatch.GetTimestamp());
        }
    }

    private sealed class UnreadableEndPoint : EndPoint
    {
        public override string ToString() => throw new NotSupportedException();
    }
}
