using System.Net;
using NeuronMocap.Recording;
using NeuronMocap.Tool.Output;
using NeuronMocap.Tool.Terminal;
using NeuronMocap.Tool.Tests.Files;
using NeuronMocap.Tool.Tests.Infrastructure;
using NeuronMocap.Tool.Watch.Recordings;

namespace NeuronMocap.Tool.Tests.Watch.Recordings;

public sealed class TakeRecorderTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();
    private readonly FrameServer _server = FrameServer.Pacing(static number => FrameServer.Motion((uint)number, new float[354]));

    public void Dispose()
    {
        _server.Dispose();
        _folder.Dispose();
    }

    [Fact]
    public async Task Each_recording_has_its_own_file_and_summary()
    {
        string path = _folder["take.nmrec"];
        await using NeuronReader reader = Connect();
        var takes = new TakeRecorder(reader, new RecordingSettings(path, new RecordingOptions { Overwrite = true }));
        Assert.True(takes.TryBegin(out string? error), error);
        long atEnd = await EndAfterFramesAsync(takes);
        Assert.Null(takes.Current);
        string told = TakeRecorder.DescribeEnd(takes.Takes[0], atEnd);
        Assert.Matches("^Recorded .+, [0-9,]+ frames, [0-9.]+ [kM]?B to .*take\\.nmrec\\.$", told);

        // The option that allows --record to replace a file does not allow the key to replace the file that --record created.
        Assert.Null(takes.Begin(DateTime.Now));
        Assert.Equal(_folder["take-2.nmrec"], takes.Current?.Recorder.CurrentPath);
        await EndAfterFramesAsync(takes);

        await reader.DisposeAsync();
        using var messages = new StringWriter();
        using var streams = new StandardStreams(Stream.Null, messages, IsTerminal: false);
        Assert.True(await takes.FinishAsync(streams));
        Assert.Equal(2, messages.ToString().Split('\n', StringSplitOptions.RemoveEmptyEntries).Length);
        foreach (Take take in takes.Takes)
        {
            Assert.InRange(take.CountFrames(0), 100, long.MaxValue);
            Assert.InRange(CountFrames(take.Recorder.Path), 1, int.MaxValue);
        }
    }

    [Fact]
    public async Task An_unwritable_folder_is_reported()
    {
        await using NeuronReader reader = Connect();
        var takes = new TakeRecorder(reader, new RecordingSettings(_folder["missing/take.nmrec"], new RecordingOptions()));
        FileFailure? failure = takes.Begin(DateTime.Now);
        Assert.StartsWith("RECORDING FAILED: ", failure?.Alarm, StringComparison.Ordinal);
        Assert.Contains("missing", failure?.Alarm, StringComparison.Ordinal);
        Assert.Null(takes.Current);
    }

    [Fact]
    public async Task An_ended_stream_is_reported()
    {
        NeuronReader reader = Connect();
        var takes = new TakeRecorder(reader, new RecordingSettings(_folder["take.nmrec"], new RecordingOptions()));
        await reader.DisposeAsync();
        Assert.Equal("RECORDING FAILED: the stream has ended.", takes.Begin(DateTime.Now)?.Alarm);
    }

    private static async Task<long> EndAfterFramesAsync(TakeRecorder takes)
    {
        Take take = takes.Current!;
        while (take.CountFrames(takes.FramesArrived) < 100 || take.Recorder.GetStatistics().Bytes == 0)
            await Task.Yield();

        long arrived = takes.FramesArrived;
        await take.StopAsync(arrived);
        return arrived;
    }

    private static int CountFrames(string path)
    {
        using RecordingReader reader = RecordingReader.Open(path);
        long bytes = 0;
        while (reader.TryRead(out RecordingEntry entry))
            bytes += entry.Bytes.Length;

        return (int)(bytes / FrameServer.Motion(0, new float[354]).Length);
    }

    private NeuronReader Connect()
    {
        var address = IPEndPoint.Parse(_server.Address);
        var reader = new NeuronReader(new NeuronReaderOptions { Host = address.Address.ToString(), Port = address.Port });
        reader.Start();
        return reader;
    }
}
