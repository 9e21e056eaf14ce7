using System.Diagnostics;
using System.Net;
using NeuronMocap.Protocol;
using NeuronMocap.Recording;

namespace NeuronMocap.Tests.Recording;

// The recorder without a reader: what its queue and its files do when the disk is slow, full, or small.
public sealed class RecorderQueueTests : IDisposable
{
    private const int PieceSize = 1000;

    private static readonly IPEndPoint Local = new(IPAddress.Loopback, 50000);
    private static readonly IPEndPoint Remote = new(IPAddress.Loopback, 7001);

    private readonly RecordingFolder _folder = new();
    private readonly StreamTap _tap = new();
    private readonly byte[] _piece = new byte[PieceSize];
    private int _sent;

    public RecorderQueueTests() => _tap.Open(isDatagrams: false, Local, Remote, Stopwatch.GetTimestamp());

    public void Dispose() => _folder.Dispose();

    [Fact]
    public async Task Pieces_that_find_no_room_are_counted_and_told_where_they_are_missing()
    {
        var disk = new HeldStream();
        StreamRecorder recorder = Start(new RecordingOptions { QueueSize = 1 << 20 }, disk);
        for (int i = 0; i < 3; i++)
        {
            Lose(recorder, disk, pieces: 100);
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
        Assert.Equal(_sent, statistics.Pieces + statistics.LostPieces);

        // A loss stands for exactly the pieces between its neighbours.
        long expected = 0;
        foreach (RecordedEntry entry in entries)
        {
            if (entry.Kind == RecordingEntryKind.BytesLost)
                expected += entry.LostPieces;
            else if (entry.Kind == RecordingEntryKind.Bytes)
                Assert.Equal(expected++, BitConverter.ToInt32(Convert.FromHexString(entry.Bytes)));
        }

        Assert.Equal(_sent, expected);
    }

    [Fact]
    public async Task Losses_at_the_very_end_are_told_too()
    {
        var disk = new HeldStream();
        StreamRecorder recorder = Start(new RecordingOptions { QueueSize = 1 << 20 }, disk);
        Lose(recorder, disk, pieces: 10);
        recorder.Stop();
        disk.LetGo();
        await recorder.Completion.Soon();
        using RecordingReader reader = RecordingReader.Open(new MemoryStream(disk.ToArray()));
        Assert.Equal(new RecordingTotals(_sent - 10, (_sent - 10) * PieceSize, 10, 10 * PieceSize), reader.Totals);
    }

    [Fact]
    public void Connections_find_room_when_pieces_do_not()
    {
        var disk = new HeldStream();
        StreamRecorder recorder = Start(new RecordingOptions { QueueSize = 1 << 20 }, disk);
        Lose(recorder, disk, pieces: 10);
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
    public async Task A_connection_whose_opening_found_no_room_is_told_with_its_first_piece()
    {
        var disk = new HeldStream();
        StreamRecorder recorder = Start(new RecordingOptions { QueueSize = 1 << 20 }, disk);
        Lose(recorder, disk, pieces: 10);
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
    public async Task A_full_disk_ends_the_recording_and_what_was_written_is_read()
    {
        using var disk = new FullStream(300_000);
        StreamRecorder recorder = Start(new RecordingOptions { FlushInterval = TimeSpan.FromSeconds(0.01) }, disk);
        await Limits.UntilAsync(() =>
        {
            Push();
            return recorder.Completion.IsCompleted;
        });

        Assert.Equal("No space left on device.", Assert.IsType<IOException>(recorder.Failure).Message);
        Assert.False(recorder.IsRecording);

        // What is told is what the file holds; what was taken and not written is lost.
        RecordingStatistics statistics = recorder.GetStatistics();
        Push();
        Assert.Equal((statistics.Pieces, statistics.LostPieces), (recorder.GetStatistics().Pieces, recorder.GetStatistics().LostPieces));
        byte[] written = disk.ToArray();
        Assert.Equal(written.Length, statistics.WrittenBytes);
        using (RecordingReader reader = RecordingReader.Open(new MemoryStream(written)))
        {
            Assert.Equal(statistics.Pieces, RecordedEntry.ReadAll(reader).Count(entry => entry.Kind == RecordingEntryKind.Bytes));
            Assert.Empty(reader.Problems);
            Assert.Equal(reader.Duration, statistics.Duration);
        }

        Assert.Equal(statistics.Pieces * PieceSize, statistics.Bytes);
        Assert.Equal(statistics.LostPieces * PieceSize, statistics.LostBytes);
        Assert.InRange(statistics.LostPieces, 1, _sent - 1 - statistics.Pieces);
        int[] numbers = [.. RecordedEntry.ReadAll(written).Where(entry => entry.Kind == RecordingEntryKind.Bytes)
            .Select(entry => BitConverter.ToInt32(Convert.FromHexString(entry.Bytes)))];
        Assert.Equal(Enumerable.Range(0, numbers.Length), numbers);

        // Less is missing than the block that found no room.
        Assert.InRange(numbers.Length, (300_000 - RecordingLayout.BlockSize - 10_000) / (PieceSize + 10), 300);
        recorder.Dispose();
    }

    [Fact]
    public void A_recorder_that_cannot_be_made_leaves_no_file_open()
    {
        var tap = new StreamTap();
        tap.Open(isDatagrams: false, new UnreadableEndPoint(), remote: null, timestamp: 0);
        var file = new MemoryStream();
        Assert.Throws<NotSupportedException>(() => new StreamRecorder(
            _folder.PathOf("take.nmrec"), new RecordingOptions(), RecordingMetadata.Empty, tap, static _ => { }, (_, _) => file));
        Assert.False(file.CanWrite);
        Assert.False(tap.IsListened);
    }

    [Fact]
    public async Task The_system_s_full_device_ends_the_recording()
    {
        Assert.SkipUnless(File.Exists("/dev/full"), "There is no /dev/full.");
        Assert.Throws<IOException>(() => new StreamRecorder(
            "/dev/full", new RecordingOptions { Overwrite = true }, RecordingMetadata.Empty, _tap, static _ => { }));

        // The first file is made, the second one finds no room.
        int files = 0;
        StreamRecorder recorder = Start(new RecordingOptions { MaxFileSize = 1 << 20 }, path => ++files == 1
            ? new FileStream(_folder.PathOf(Path.GetFileName(path)), FileMode.CreateNew)
            : new FileStream("/dev/full", FileMode.Open, FileAccess.Write, FileShare.ReadWrite, bufferSize: 1));
        await Limits.UntilAsync(() =>
        {
            Push();
            return recorder.Completion.IsCompleted;
        });
        Assert.IsType<IOException>(recorder.Failure, exactMatch: false);
        using RecordingReader reader = RecordingReader.Open(_folder.PathOf("take.0001.nmrec"));
        Assert.NotEmpty(RecordedEntry.ReadAll(reader));
    }

    // There is no room for the beginning of the third file, or for all of the second.
    [Theory, InlineData(3, 50), InlineData(2, 500_000)]
    public async Task A_full_disk_behind_other_files_is_counted_over_all_of_them(int full, int room)
    {
        var files = new List<MemoryStream>();
        StreamRecorder recorder = Start(new RecordingOptions { MaxFileSize = 1 << 20 }, _ =>
        {
            files.Add(files.Count + 1 == full ? new FullStream(room) : new MemoryStream());
            return files[^1];
        });
        await Limits.UntilAsync(() =>
        {
            Push();
            return recorder.Completion.IsCompleted;
        });

        Assert.IsType<IOException>(recorder.Failure);
        RecordingStatistics statistics = recorder.GetStatistics();
        Assert.Equal(statistics.Pieces, files.Where(file => file.ToArray().Length > 0).Sum(file =>
            RecordedEntry.ReadAll(file.ToArray()).Count(entry => entry.Kind == RecordingEntryKind.Bytes)));
        Assert.True(statistics.LostPieces > 0);
        using RecordingReader first = RecordingReader.Open(new MemoryStream(files[0].ToArray()));
        using RecordingReader last = RecordingReader.Open(new MemoryStream(files.Last(file => file.ToArray().Length > 0).ToArray()));
        Assert.Equal(last.StartTime - first.StartTime + last.Duration, statistics.Duration);
    }

    [Fact]
    public async Task An_old_file_that_cannot_be_deleted_does_not_end_the_recording_and_is_tried_again()
    {
        var options = new RecordingOptions { MaxFileSize = 1 << 20, MaxFiles = 1 };
        StreamRecorder recorder = new(_folder.PathOf("take.nmrec"), options, RecordingMetadata.Empty, _tap, static _ => { });
        await FillAsync(recorder, files: 1);
        string first = _folder.PathOf("take.0001.nmrec");
        File.Delete(first);
        Directory.CreateDirectory(first);
        await FillAsync(recorder, files: 3);

        Assert.True(recorder.IsRecording, $"{recorder.Failure}");
        Assert.Equal(1, recorder.GetStatistics().UndeletedFiles);
        Assert.False(File.Exists(_folder.PathOf("take.0002.nmrec")));
        Directory.Delete(first);
        await File.WriteAllTextAsync(first, "old", TestContext.Current.CancellationToken);
        await FillAsync(recorder, files: 5);
        recorder.Dispose();
        Assert.Null(recorder.Failure);
        Assert.Equal(0, recorder.GetStatistics().UndeletedFiles);
        Assert.False(File.Exists(first));
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

    [Theory, InlineData(null), InlineData(3)]
    public async Task Files_of_bounded_size_follow_each_other_and_each_is_whole(int? maxFiles)
    {
        const int Size = 1 << 20;
        string[] names = [];
        var options = new RecordingOptions { MaxFileSize = Size, MaxFiles = maxFiles };
        StreamRecorder recorder = new(_folder.PathOf("take.nmrec"), options, new RecordingMetadata().With("server", "studio"), _tap, static _ => { });
        _tap.OnBytes(0, [2, 0, 27, 88, 127, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0], [1], Stopwatch.GetTimestamp());
        recorder.SetMetadata("rotation-order", "XYZ");
        while (recorder.GetStatistics().Files < 6)
        {
            Push();
            if (_sent % 256 == 0)
                await Task.Delay(1, TestContext.Current.CancellationToken);
        }

        recorder.Dispose();
        Assert.Null(recorder.Failure);
        Assert.Equal(0, recorder.GetStatistics().LostPieces);
        names = _folder.Files;
        int first = maxFiles is { } count ? recorder.GetStatistics().Files - count + 1 : 1;
        Assert.Equal(Enumerable.Range(first, names.Length).Select(number => $"take.{number:0000}.nmrec"), names);
        Assert.Equal(maxFiles ?? recorder.GetStatistics().Files, names.Length);
        Assert.Equal(_folder.PathOf(names[^1]), recorder.CurrentPath);

        int? next = maxFiles is null ? 0 : null;
        DateTimeOffset last = DateTimeOffset.MinValue;
        Guid id = Guid.Empty;
        foreach (string name in names)
        {
            string path = _folder.PathOf(name);
            Assert.InRange(new FileInfo(path).Length, 1, Size);
            using RecordingReader reader = RecordingReader.Open(path);
            Assert.True(reader.IsComplete);
            Assert.Equal(("studio", "XYZ"), (reader.Metadata["server"], reader.Metadata["rotation-order"]));
            Assert.Equal(first++, reader.FileNumber);
            Assert.True(reader.StartTime > last && (id == Guid.Empty || id == reader.RecordingId));
            (last, id) = (reader.StartTime + reader.Duration, reader.RecordingId);
            List<RecordedEntry> entries = RecordedEntry.ReadAll(reader);
            Assert.True(Assert.Single(entries, entry => entry.Kind == RecordingEntryKind.ConnectionOpened).Opened!.WasOpen);
            Assert.Single(entries, entry => entry.Kind == RecordingEntryKind.SenderAdded);
            foreach (RecordedEntry entry in entries.Where(entry => entry.Kind == RecordingEntryKind.Bytes && entry.Bytes.Length > 2))
            {
                int number = BitConverter.ToInt32(Convert.FromHexString(entry.Bytes));
                Assert.Equal(next ?? number, number);
                next = number + 1;
            }
        }

        Assert.Equal(_sent, next);
    }

    [Fact]
    public async Task A_numbered_file_of_an_earlier_recording_is_found_before_anything_is_recorded()
    {
        string later = _folder.PathOf("take.0098.nmrec");
        await File.WriteAllTextAsync(later, "precious", TestContext.Current.CancellationToken);
        await File.WriteAllTextAsync(_folder.PathOf("take.x.nmrec"), "another", TestContext.Current.CancellationToken);
        await File.WriteAllTextAsync(_folder.PathOf("take2.0001.nmrec"), "another", TestContext.Current.CancellationToken);
        var options = new RecordingOptions { MaxFileSize = 1 << 20 };
        IOException error = Assert.Throws<IOException>(
            () => new StreamRecorder(_folder.PathOf("take.nmrec"), options, RecordingMetadata.Empty, _tap, static _ => { }));
        Assert.Contains(later, error.Message, StringComparison.Ordinal);
        Assert.Equal("precious", await File.ReadAllTextAsync(later, TestContext.Current.CancellationToken));

        options.Overwrite = true;
        new StreamRecorder(_folder.PathOf("take.nmrec"), options, RecordingMetadata.Empty, _tap, static _ => { }).Dispose();
        File.Delete(later);
        options.Overwrite = false;
        new StreamRecorder(_folder.PathOf("take2.x.nmrec"), options, RecordingMetadata.Empty, _tap, static _ => { }).Dispose();
        Assert.Contains("take2.x.0001.nmrec", _folder.Files);
    }

    [Fact]
    public async Task Files_of_bounded_duration_follow_each_other()
    {
        StreamRecorder recorder = new(
            _folder.PathOf("take.nmrec"), new RecordingOptions { MaxFileDuration = TimeSpan.FromSeconds(1) }, RecordingMetadata.Empty, _tap, static _ => { });
        while (recorder.GetStatistics().Files < 2)
        {
            Push();
            await Task.Delay(20, TestContext.Current.CancellationToken);
        }

        recorder.Dispose();
        using RecordingReader first = RecordingReader.Open(_folder.PathOf("take.0001.nmrec"));
        using RecordingReader second = RecordingReader.Open(_folder.PathOf("take.0002.nmrec"));
        Assert.True(first.Duration < TimeSpan.FromSeconds(1));
        Assert.True(second.StartTime - first.StartTime >= TimeSpan.FromSeconds(1));
        Assert.Equal(_sent, first.Totals!.Value.Pieces + second.Totals!.Value.Pieces);
    }

    [Fact]
    public void A_piece_costs_the_receive_thread_no_allocation()
    {
        byte[] sender = new byte[16];
        sender[0] = 2;
        var disk = new HeldStream();
        StreamRecorder recorder = Start(new RecordingOptions { QueueSize = 1 << 24 }, disk);
        byte[] datagram = new byte[784];
        Allocations.AssertNone(() => _tap.OnBytes(7, sender, datagram, Stopwatch.GetTimestamp()));
        recorder.Dispose();
        Assert.Equal(0, recorder.GetStatistics().LostPieces);
        Allocations.AssertNone(() => _tap.OnBytes(7, sender, datagram, Stopwatch.GetTimestamp()));
    }

    [Fact]
    public async Task What_has_arrived_is_in_the_file_soon_without_an_end()
    {
        StreamRecorder recorder = new(
            _folder.PathOf("take.nmrec"), new RecordingOptions { FlushInterval = TimeSpan.FromSeconds(0.01) }, RecordingMetadata.Empty, _tap, static _ => { });
        Push();
        await Limits.UntilAsync(() =>
        {
            using RecordingReader reader = RecordingReader.Open(_folder.PathOf("take.nmrec"));
            Assert.False(reader.IsComplete);
            return RecordedEntry.ReadAll(reader).Exists(entry => entry.Kind == RecordingEntryKind.Bytes);
        });
        recorder.Dispose();
    }

    private async Task FillAsync(StreamRecorder recorder, int files)
    {
        await Limits.UntilAsync(() =>
        {
            Push();
            return recorder.GetStatistics().Files >= files || !recorder.IsRecording;
        });
    }

    // The disk takes nothing from here on.
    private void Lose(StreamRecorder recorder, HeldStream disk, int pieces)
    {
        disk.Hold();
        long lost = recorder.GetStatistics().LostPieces;
        while (recorder.GetStatistics().LostPieces < lost + pieces)
            Push();
    }

    private async Task PushUntilTakenAsync(StreamRecorder recorder)
    {
        long taken = recorder.GetStatistics().Pieces;
        await Limits.UntilAsync(() =>
        {
            Push();
            return recorder.GetStatistics().Pieces > taken;
        });
    }

    private void Reconnect(int times)
    {
        for (int i = 0; i < times; i++)
        {
            _tap.Close("Reset", Stopwatch.GetTimestamp());
            _tap.Open(isDatagrams: false, Local, Remote, Stopwatch.GetTimestamp());
        }
    }

    private void Push()
    {
        BitConverter.TryWriteBytes(_piece, _sent++);
        _tap.OnBytes(0, [], _piece, Stopwatch.GetTimestamp());
    }

    private StreamRecorder Start(RecordingOptions options, Stream stream) => Start(options, _ => stream);

    private StreamRecorder Start(RecordingOptions options, Func<string, Stream> open) =>
        new("take.nmrec", options, RecordingMetadata.Empty, _tap, static _ => { }, (path, _) => open(path));

    private sealed class UnreadableEndPoint : EndPoint
    {
        public override string ToString() => throw new NotSupportedException();
    }
}
