using System.Diagnostics;
using NeuronMocap.Recording;

namespace NeuronMocap.Tests.Recording;

// Recordings of several files.
public sealed class RecorderFilesTests : RecorderTest
{
    [Fact]
    public async Task An_undeletable_old_file_is_retried()
    {
        var options = new RecordingOptions { MaxFileSize = 1 << 20, MaxFiles = 1 };
        StreamRecorder recorder = new(Folder.PathOf("take.nmrec"), options, RecordingMetadata.Empty, Tap, static _ => { });
        await FillAsync(recorder, files: 1);
        string first = Folder.PathOf("take.0001.nmrec");
        File.Delete(first);
        Directory.CreateDirectory(first);
        await FillAsync(recorder, files: 3);

        Assert.True(recorder.IsRecording, $"{recorder.Failure}");
        Assert.Equal(1, recorder.GetStatistics().UndeletedFiles);
        await Limits.UntilAsync(() => !File.Exists(Folder.PathOf("take.0002.nmrec")));
        Directory.Delete(first);
        await File.WriteAllTextAsync(first, "old", TestContext.Current.CancellationToken);
        await FillAsync(recorder, files: 5);
        recorder.Dispose();
        Assert.Null(recorder.Failure);
        Assert.Equal(0, recorder.GetStatistics().UndeletedFiles);
        Assert.False(File.Exists(first));
    }

    [Fact]
    public async Task Metadata_does_not_wait_until_the_queue_is_empty()
    {
        StreamRecorder? recorder = null;
        using var isReady = new ManualResetEventSlim();
        int opened = 0;
        recorder = new(Folder.PathOf("take.nmrec"), new RecordingOptions { MaxFileSize = 1 << 20 }, RecordingMetadata.Empty, Tap, static _ => { }, (path, _) =>
        {
            // Between two pieces of the recording's thread, with more pieces than the next file holds.
            if (++opened == 2)
            {
                Assert.True(isReady.Wait(Limits.Unexpected));
                recorder!.SetMetadata("rotation-order", "XYZ");
                for (int i = 0; i < 2500; i++)
                    Push();
            }

            return File.Create(path);
        });
        for (int i = 0; i < 1200; i++)
            Push();

        isReady.Set();
        await Limits.UntilAsync(() => recorder.GetStatistics().Files >= 4);
        recorder.Dispose();
        Assert.Equal(0, recorder.GetStatistics().LostPieces);
        using RecordingReader reader = RecordingReader.Open(Folder.PathOf("take.0003.nmrec"));
        Assert.Equal("XYZ", reader.Metadata["rotation-order"]);
    }

    [Theory, InlineData(null), InlineData(3)]
    public async Task Size_limited_files_are_each_complete(int? maxFiles)
    {
        const int Size = 1 << 20;
        string[] names = [];
        var options = new RecordingOptions { MaxFileSize = Size, MaxFiles = maxFiles };
        StreamRecorder recorder = new(Folder.PathOf("take.nmrec"), options, new RecordingMetadata().With("server", "studio"), Tap, static _ => { });
        Tap.OnBytes(0, [2, 0, 27, 88, 127, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0], new ArraySegment<byte>([1]), Stopwatch.GetTimestamp());
        recorder.SetMetadata("rotation-order", "XYZ");
        while (recorder.GetStatistics().Files < 6)
        {
            // Never more than the queue holds, because a busy machine writes late.
            Push();
            await Limits.UntilAsync(() => Sent - recorder.GetStatistics().Pieces < Size / PieceSize);
        }

        recorder.Dispose();
        Assert.Null(recorder.Failure);
        Assert.Equal(0, recorder.GetStatistics().LostPieces);
        names = Folder.Files;
        int first = maxFiles is { } count ? recorder.GetStatistics().Files - count + 1 : 1;
        Assert.Equal(Enumerable.Range(first, names.Length).Select(number => $"take.{number:0000}.nmrec"), names);
        Assert.Equal(maxFiles ?? recorder.GetStatistics().Files, names.Length);
        Assert.Equal(Folder.PathOf(names[^1]), recorder.CurrentPath);

        int? next = maxFiles is null ? 0 : null;
        DateTimeOffset last = DateTimeOffset.MinValue;
        Guid id = Guid.Empty;
        foreach (string name in names)
        {
            string path = Folder.PathOf(name);
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

        Assert.Equal(Sent, next);
    }

    [Fact]
    public async Task An_existing_numbered_file_is_refused_at_the_start()
    {
        string later = Folder.PathOf("take.0098.nmrec");
        await File.WriteAllTextAsync(later, "precious", TestContext.Current.CancellationToken);
        await File.WriteAllTextAsync(Folder.PathOf("take.x.nmrec"), "another", TestContext.Current.CancellationToken);
        await File.WriteAllTextAsync(Folder.PathOf("take2.0001.nmrec"), "another", TestContext.Current.CancellationToken);
        var options = new RecordingOptions { MaxFileSize = 1 << 20 };
        IOException error = Assert.Throws<IOException>(
            () => new StreamRecorder(Folder.PathOf("take.nmrec"), options, RecordingMetadata.Empty, Tap, static _ => { }));
        Assert.Contains(later, error.Message, StringComparison.Ordinal);
        Assert.Equal("precious", await File.ReadAllTextAsync(later, TestContext.Current.CancellationToken));

        options.Overwrite = true;
        new StreamRecorder(Folder.PathOf("take.nmrec"), options, RecordingMetadata.Empty, Tap, static _ => { }).Dispose();
        File.Delete(later);
        options.Overwrite = false;
        new StreamRecorder(Folder.PathOf("take2.x.nmrec"), options, RecordingMetadata.Empty, Tap, static _ => { }).Dispose();
        Assert.Contains("take2.x.0001.nmrec", Folder.Files);
    }

    [Fact]
    public async Task Duration_limited_files_follow_each_other()
    {
        StreamRecorder recorder = new(
            Folder.PathOf("take.nmrec"), new RecordingOptions { MaxFileDuration = TimeSpan.FromSeconds(1) }, RecordingMetadata.Empty, Tap, static _ => { });
        while (recorder.GetStatistics().Files < 2)
        {
            Push();
            await Task.Delay(20, TestContext.Current.CancellationToken);
        }

        recorder.Dispose();
        using RecordingReader first = RecordingReader.Open(Folder.PathOf("take.0001.nmrec"));
        using RecordingReader second = RecordingReader.Open(Folder.PathOf("take.0002.nmrec"));
        Assert.True(first.Duration < TimeSpan.FromSeconds(1));
        Assert.True(second.StartTime - first.StartTime >= TimeSpan.FromSeconds(1));

        // On a busy computer, there can be more of them.
        Assert.Equal(Sent, Folder.Files.Sum(name =>
        {
            using RecordingReader file = RecordingReader.Open(Folder.PathOf(name));
            return file.Totals!.Value.Pieces;
        }));
    }

    private Task FillAsync(StreamRecorder recorder, int files) =>
        PushUntilAsync(() => recorder.GetStatistics().Files >= files || !recorder.IsRecording);
}
