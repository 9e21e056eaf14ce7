using NeuronMocap.Bvh;
using NeuronMocap.Recording;
using NeuronMocap.Tool.Files;
using NeuronMocap.Tool.Terminal;
using NeuronMocap.Tool.Watch.Export;
using NeuronMocap.Tool.Watch.Recordings;

namespace NeuronMocap.Tool.Relay.Destinations;

/// <summary>A recording that is being written.</summary>
internal sealed class RecordingOutlet(TakeRecorder takes, string file) : Outlet
{
    private readonly StreamRecorder _recorder = takes.Takes[0].Recorder;

    public override string Name => file;

    public override string Announcement => $"Recording to {file}";

    public override string Noun => "piece";

    public override OutletFigures GetFigures()
    {
        RecordingStatistics statistics = _recorder.GetStatistics();
        return new OutletFigures(statistics.Pieces, statistics.LostPieces)
        {
            Bytes = statistics.Bytes,
            Failure = _recorder.Failure is { } failure ? FileFault.OfWriting(failure, file) : null,
        };
    }

    public override Task<bool> FinishAsync(StandardStreams streams) => takes.FinishAsync(streams);

    public override ValueTask DisposeAsync() => _recorder.DisposeAsync();
}

/// <summary>A BVH file that is being written.</summary>
internal sealed class BvhOutlet(ExportRun run, string file) : Outlet
{
    private readonly BvhExport _export = run.Export!;

    public override string Name => file;

    public override string Announcement => $"Exporting to {file}";

    public override string Noun => "frame";

    public override OutletFigures GetFigures() => new(_export.FramesWritten, _export.FramesDropped)
    {
        Failure = _export.Failure is { } failure ? FileFault.OfWriting(failure, file) : null,
    };

    public override Task<bool> FinishAsync(StandardStreams streams) => Task.Run(() => run.TryFinish(streams));

    public override ValueTask DisposeAsync() => _export.DisposeAsync();
}
