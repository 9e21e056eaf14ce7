using System.Collections.Concurrent;
using NeuronMocap.Protocol;
using NeuronMocap.Recording;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Commands;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Recording;

// A reader's events about its recordings, and the recordings' information about their reader.
public sealed class RecordingEventTests : IDisposable
{
    private readonly RecordingFolder _folder = new();
    private readonly ConcurrentQueue<ReaderEvent> _events = [];

    public void Dispose() => _folder.Dispose();

    [Fact]
    public async Task Start_and_end_of_a_recording_are_reported()
    {
        using var server = new TestServer();
        await using var reader = new NeuronReader(server.Options());
        reader.EventReported += _events.Enqueue;
        string path = _folder.PathOf("take.nmrec");
        reader.StartRecording(path);
        reader.Start();
        using TestConnection connection = await server.AcceptAsync();
        await connection.SendAsync(TestPackets.Motion(1));
        await reader.WaitForFramesAsync(1);
        await reader.DisposeAsync();

        ReaderEvent[] told = [.. _events.Where(news => news.Id >= ReaderEventId.RecordingStarted)];
        Assert.Equal([ReaderEventId.RecordingStarted, ReaderEventId.RecordingStopped], told.Select(news => news.Id));
        Assert.All(told, news => Assert.Equal((ReaderEventLevel.Information, path), (news.Level, news.Subject!)));
        Assert.Contains("Recorded 1480 bytes", told[1].Message, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_failed_recording_is_reported_once_and_the_reader_goes_on()
    {
        // The second file is a link to a device without room.
        using FullDevice full = await FullDevice.LinkAsync(_folder.PathOf("take.0002.nmrec"));
        using var server = new TestServer();
        await using var reader = new NeuronReader(server.Options());
        reader.EventReported += _events.Enqueue;

        var options = new RecordingOptions { MaxFileSize = 1 << 20, Overwrite = true };
        StreamRecorder recorder = reader.StartRecording(_folder.PathOf("take.nmrec"), options);
        reader.Start();
        using TestConnection connection = await server.AcceptAsync();
        int sent = 0;
        while (!recorder.Completion.IsCompleted)
            await connection.SendAsync(TestPackets.Motion(++sent));

        await connection.SendAsync(TestPackets.Motion(++sent));
        await reader.WaitForFramesAsync(sent);
        await Limits.UntilAsync(() => _events.Any(news => news.Id == ReaderEventId.RecordingFailed));
        Assert.IsType<IOException>(recorder.Failure, exactMatch: false);
        await reader.DisposeAsync();
        ReaderEvent failed = Assert.Single(_events, news => news.Id == ReaderEventId.RecordingFailed);
        Assert.Equal((ReaderEventLevel.Error, recorder.Failure), (failed.Level, failed.Exception));
        Assert.DoesNotContain(_events, news => news.Id == ReaderEventId.RecordingStopped);
    }

    [Fact]
    public async Task Answers_of_the_command_channel_are_recorded()
    {
        var dimensions = new BoneDimensions { Head = 0.17f, Neck = 0.1f, Body = 0.51f, FootLength = 1f / 3 };
        byte[] sizes = new byte[BoneDimensions.Size];
        dimensions.Write(sizes);
        using var commands = new CommandScript(request => (CommandChannelId)request.Id switch
        {
            CommandChannelId.RotationOrder => request.ReplyAsync([(byte)RotationOrder.ZXY, 0, 0, 0]),
            CommandChannelId.BoneDimensions => request.ReplyAsync(sizes),
            _ => request.ReplyAsync([]),
        });
        using var server = new TestServer();
        NeuronReaderOptions options = server.Options();
        options.CommandPort = commands.Port;
        options.Name = "stage left";
        await using var reader = new NeuronReader(options);
        string path = _folder.PathOf("take.nmrec");
        reader.StartRecording(path, new RecordingOptions { FlushInterval = TimeSpan.FromSeconds(0.01) });
        reader.Start();
        using TestConnection connection = await server.AcceptAsync();
        await connection.SendAsync(TestPackets.Motion(1));
        await Limits.UntilAsync(() =>
        {
            using RecordingReader growing = RecordingReader.Open(path);
            return growing.Metadata is { BoneDimensions: not null, RotationOrder: not null } metadata && metadata[RecordingMetadata.StreamFormatKey] is not null;
        });
        await reader.DisposeAsync();

        using RecordingReader recorded = RecordingReader.Open(path);
        Assert.Equal(dimensions, recorded.Metadata.BoneDimensions);
        Assert.Equal(RotationOrder.ZXY, recorded.Metadata.RotationOrder);
        Assert.Equal(
            ("stage left", $"127.0.0.1:{server.Port}", "Binary"),
            (recorded.Metadata[RecordingMetadata.ReaderKey], recorded.Metadata[RecordingMetadata.ServerKey], recorded.Metadata[RecordingMetadata.StreamFormatKey]));
    }
}
