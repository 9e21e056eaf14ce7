using NeuronMocap.Bvh;
using NeuronMocap.Server;
using NeuronMocap.Tests.Network;
using NeuronMocap.Tests.Recording;

namespace NeuronMocap.Tests.Reader;

// How an export treats its file: if it exists, if it cannot be written or closed, and if no frame arrived.
public sealed class BvhExportFileTests : BvhExportTest
{
    [Fact]
    public async Task An_existing_file_is_replaced_only_by_option_and_with_a_frame()
    {
        await File.WriteAllTextAsync(Target, "precious", TestContext.Current.CancellationToken);
        using var reader = new NeuronReader(Server.Options());
        Assert.Throws<IOException>(() => reader.ExportBvh(Target));

        reader.ExportBvh(Target, new BvhExportOptions { Overwrite = true }).Dispose();
        Assert.Equal("precious", await File.ReadAllTextAsync(Target, TestContext.Current.CancellationToken));

        string other = Path.Combine(Folder.FullName, "other.bvh");
        reader.ExportBvh(other).Dispose();
        Assert.False(File.Exists(other));
        Assert.Throws<DirectoryNotFoundException>(() => reader.ExportBvh(Path.Combine(Folder.FullName, "nowhere", "take.bvh")));
        Assert.Throws<ArgumentException>(() => reader.ExportBvh(" "));
        Assert.Throws<ArgumentOutOfRangeException>(() => reader.ExportBvh(other, new BvhExportOptions { Capacity = 0 }));
        Assert.Throws<ArgumentOutOfRangeException>(() => reader.ExportBvh(other, new BvhExportOptions { MaxFrames = 0 }));
        Assert.Throws<ArgumentOutOfRangeException>(() => reader.ExportBvh(other, new BvhExportOptions { MaxFrames = -1 }));
    }

    // It may be a device. An export does not delete files that it did not create.
    [Theory]
    [InlineData(0)]
    [InlineData(3)]
    public async Task An_empty_export_keeps_an_existing_file(int room)
    {
        await File.WriteAllTextAsync(Target, string.Empty, TestContext.Current.CancellationToken);
        await using var reader = new NeuronReader(Server.Options());
        await using (BvhExport export = reader.ExportBvhTo(Target, new BvhExportOptions { Overwrite = true }, _ => new FullStream(room)))
        {
            reader.Start();
            using TestConnection connection = await Server.AcceptAsync();
            await connection.SendAsync(TestPackets.Motions(0, 3));
            await export.Completion.Soon();
            Assert.NotNull(export.Failure);
        }

        Assert.True(File.Exists(Target));
    }

    // Once it is closed, the file may belong to another writer.
    [Theory]
    [InlineData(0)]
    [InlineData(3)]
    public async Task An_empty_file_is_deleted_before_it_is_closed(int frames)
    {
        FullFile? file = null;
        await using var reader = new NeuronReader(Server.Options());
        await using (BvhExport export = reader.ExportBvhTo(Target, options: null, path => file = new FullFile(path)))
        {
            reader.Start();
            using TestConnection connection = await Server.AcceptAsync();
            await connection.SendAsync(TestPackets.Motions(0, frames));
            await reader.WaitForFramesAsync(frames);
        }

        Assert.True(file!.IsClosed);
        Assert.False(file.WasThereWhenClosed);
        Assert.False(File.Exists(Target));
    }

    [Fact]
    public async Task A_failed_close_fails_the_export()
    {
        await using var reader = new NeuronReader(Server.Options());
        await using BvhExport export = reader.ExportBvhTo(Target, options: null, static _ => new UnclosableStream());
        reader.Start();
        using TestConnection connection = await Server.AcceptAsync();
        await connection.SendAsync(TestPackets.Motions(0, 3));
        await reader.WaitForFramesAsync(3);
        await export.StopAsync(TestContext.Current.CancellationToken).Soon();
        Assert.IsType<NotSupportedException>(export.Failure);
    }

    [Fact]
    public async Task A_file_that_cannot_be_emptied_is_closed()
    {
        var file = new UnemptiableStream();
        await using var reader = new NeuronReader(Server.Options());
        await using BvhExport export = reader.ExportBvhTo(Target, options: null, _ => file);
        reader.Start();
        using TestConnection connection = await Server.AcceptAsync();
        await connection.SendAsync(TestPackets.Motions(0, 3));
        await export.Completion.Soon();
        Assert.IsType<UnauthorizedAccessException>(export.Failure);
        Assert.False(file.CanWrite);
    }

    [Fact]
    public async Task A_full_disk_ends_the_export_with_the_reported_frames()
    {
        const int Sent = 200;
        var events = new System.Collections.Concurrent.ConcurrentQueue<ReaderEvent>();
        var disk = new FullStream(150_000);
        await using var reader = new NeuronReader(Server.Options());
        reader.EventReported += events.Enqueue;
        await using BvhExport export = reader.ExportBvhTo(Target, options: null, _ => disk);
        reader.Start();
        using TestConnection connection = await Server.AcceptAsync();
        await connection.SendAsync(TestPackets.Motions(0, Sent));
        await export.Completion.Soon();

        Assert.Equal("No space left on device.", Assert.IsType<IOException>(export.Failure).Message);
        BvhDocument read = BvhDocument.Parse(disk.ToArray());
        Assert.Empty(read.Repairs);
        Assert.Equal(read.FrameCount, export.FramesWritten);
        Assert.Equal(read.FrameCount, Assert.Single(export.Files).FrameCount);
        Assert.InRange(read.FrameCount, 1, Sent - 1);
        Assert.InRange(export.FramesDropped, 1, Sent - read.FrameCount);
        Assert.Equal(TestPackets.Value(read.FrameCount - 1, 0, 5), read.GetValues(read.FrameCount - 1)[5]);

        // Reported at once, and the reader continues.
        await Limits.UntilAsync(() => events.Any(static news => news.Id == ReaderEventId.ExportFailed));
        ReaderEvent failed = Assert.Single(events, static news => news.Id == ReaderEventId.ExportFailed);
        Assert.Equal((ReaderEventLevel.Error, export.Failure, Target), (failed.Level, failed.Exception, failed.Subject));
        Assert.Contains($"holds {read.FrameCount} frames", failed.Message, StringComparison.Ordinal);
        await connection.SendAsync(TestPackets.Motions(Sent, 1));
        await reader.WaitForFramesAsync(Sent + 1);
        Assert.DoesNotContain(events, static news => news.Id == ReaderEventId.ExportStopped);
    }

    // What a process killed at this moment would leave behind: the data already passed to the system.
    [Fact]
    public async Task The_file_is_always_readable_up_to_the_last_flush()
    {
        await using var broadcaster = new Broadcaster(new BroadcasterOptions { Sources = [new SyntheticSource(240)], Port = 0 });
        broadcaster.Start();
        await using var reader = new NeuronReader(new NeuronReaderOptions { Port = broadcaster.LocalEndPoint!.Port });
        using BvhExport export = reader.ExportBvh(Target);
        reader.Start();

        var random = new Random(5);
        await Limits.UntilAsync(() => export.FramesWritten > 0);
        for (int moment = 0; moment < 20; moment++)
        {
            await Task.Delay(random.Next(30), TestContext.Current.CancellationToken);
            long known = export.FramesWritten;
            BvhDocument read = BvhDocument.Parse(ReadShared());
            Assert.True(read.FrameCount >= known, $"{read.FrameCount} of {known} rows.");
            Assert.Equal(354, read.ChannelCount);
        }
    }

    private byte[] ReadShared()
    {
        using var stream = new FileStream(Target, FileMode.Open, FileAccess.Read, FileShare.ReadWrite);
        byte[] bytes = new byte[stream.Length];
        stream.ReadExactly(bytes);
        return bytes;
    }

    private sealed class FullFile(string path) : FileStream(path, FileMode.CreateNew, FileAccess.Write, FileShare.Read | FileShare.Delete, bufferSize: 1)
    {
        public bool IsClosed { get; private set; }

        public bool WasThereWhenClosed { get; private set; }

        public override void Write(byte[] array, int offset, int count) => throw new IOException("No space left on device.");

        protected override void Dispose(bool disposing)
        {
            if (!IsClosed)
                WasThereWhenClosed = File.Exists(Name);

            IsClosed = true;
            base.Dispose(disposing);
        }
    }

    private sealed class UnclosableStream : MemoryStream
    {
        protected override void Dispose(bool disposing)
        {
            base.Dispose(disposing);
            throw new NotSupportedException();
        }
    }

    private sealed class UnemptiableStream() : MemoryStream(new byte[8])
    {
        public override void SetLength(long value) => throw new UnauthorizedAccessException();
    }
}
