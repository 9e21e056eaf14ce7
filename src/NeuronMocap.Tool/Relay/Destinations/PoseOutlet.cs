using NeuronMocap.Server;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Relay.Destinations;

/// <summary>A program that gets poses.</summary>
internal sealed class PoseOutlet(PoseSender sender, string name) : Outlet
{
    private long _refusals;

    public override string Name => name;

    public override string Announcement => $"Sending poses to {name}";

    public override string Unit => "poses";

    // One thread at a time asks.
    public override OutletFigures GetFigures()
    {
        PoseSenderStatistics statistics = sender.GetStatistics();
        bool isRefused = statistics.Refusals > _refusals;
        _refusals = statistics.Refusals;
        return new OutletFigures(statistics.FramesSent, statistics.FramesDropped)
        {
            Bytes = statistics.BytesSent,
            Failure = statistics.Failure ?? sender.Completion.Exception?.InnerException?.Message,
            Note = isRefused ? "no program receives on that port" : null,
        };
    }

    // A receiver that is off is no fault of the relay.
    public override async Task<bool> FinishAsync(StandardStreams streams)
    {
        await Task.WhenAny(sender.Completion);
        return true;
    }

    public override ValueTask DisposeAsync() => sender.DisposeAsync();
}
