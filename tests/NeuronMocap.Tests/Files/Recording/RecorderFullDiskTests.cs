using NeuronMocap.Recording;

namespace NeuronMocap.Tests.Recording;

// The recorder's behaviour on a full disk.
public sealed class RecorderFullDiskTests : RecorderTest
{
    [Fact]
    public async Task A_full_disk_ends_the_recording_and_keeps_what_was_written()
    {
        using var disk = new FullStream(300_000);
        StreamRecorder recorder = Start(new RecordingOptions { FlushInterval = TimeSpan.FromSeconds(0.01) }, disk);
        await PushUntilAsync(() => recorder.Completion.IsCompleted);

        Assert.Equal("No space left on device.", Assert.IsType<IOException>(recorder.Failure).Message);
        Assert.False(recorder.IsRecording);

        // The statistics count what the file holds. Pieces that were taken but not written are lost.
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
        Assert.InRange(statistics.LostPieces, 1, Sent - 1 - statistics.Pieces);
        int[] numbers = [.. RecordedEntry.ReadAll(written).Where(entry => entry.Kind == RecordingEntryKind.Bytes)
            .Select(entry => BitConverter.ToInt32(Convert.FromHexString(entry.Bytes)))];
        Assert.Equal(Enumerable.Range(0, numbers.Length), numbers);

        // Less is missing than the block that did not fit.
        Assert.InRange(numbers.Length, (300_000 - RecordingLayout.BlockSize - 10_000) / (PieceSize + 10), 300);
        recorder.Dispose();
    }

    [Fact]
    public async Task The_full_device_ends_the_recording()
    {
        Assert.SkipUnless(File.Exists("/dev/full"), "There is no /dev/full.");
        Assert.Throws<IOException>(() => new StreamRecorder(
            "/dev/full", new RecordingOptions { Overwrite = true }, RecordingMetadata.Empty, Tap, static _ => { }));

        // The first file is created. The second does not fit.
        int files = 0;
        StreamRecorder recorder = Start(new RecordingOptions { MaxFileSize = 1 << 20 }, path => ++files == 1
            ? new FileStream(Folder.PathOf(Path.GetFileName(path)), FileMode.CreateNew)
            : new FileStream("/dev/full", FileMode.Open, FileAccess.Write, FileShare.ReadWrite, bufferSize: 1));
        await PushUntilAsync(() => recorder.Completion.IsCompleted);
        Assert.IsType<IOException>(recorder.Failure, exactMatch: false);
        using RecordingReader reader = RecordingReader.Open(Folder.PathOf("take.0001.nmrec"));
        Assert.NotEmpty(RecordedEntry.ReadAll(reader));
    }

    // There is no room for the start of the third file, or for all of the second.
    [Theory, InlineData(3, 50), InlineData(2, 500_000)]
    public async Task A_full_disk_counts_losses_over_all_files(int full, int room)
    {
        var files = new List<MemoryStream>();
        StreamRecorder recorder = Start(new RecordingOptions { MaxFileSize = 1 << 20 }, _ =>
        {
            files.Add(files.Count + 1 == full ? new FullStream(room) : new MemoryStream());
            return files[^1];
        });
        await PushUntilAsync(() => recorder.Completion.IsCompleted);

        Assert.IsType<IOException>(recorder.Failure);
        RecordingStatistics statistics = recorder.GetStatistics();
        Assert.Equal(statistics.Pieces, files.Where(file => file.ToArray().Length > 0).Sum(file =>
            RecordedEntry.ReadAll(file.ToArray()).Count(entry => entry.Kind == RecordingEntryKind.Bytes)));
        Assert.True(statistics.LostPieces > 0);
        using RecordingReader first = RecordingReader.Open(new MemoryStream(files[0].ToArray()));
        using RecordingReader last = RecordingReader.Open(new MemoryStream(files.Last(file => file.ToArray().Length > 0).ToArray()));
        Assert.Equal(last.StartTime - first.StartTime + last.Duration, statistics.Duration);
    }
}
