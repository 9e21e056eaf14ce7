using NeuronMocap.Server;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Relay.Destinations;

/// <summary>A program that gets poses.</summary>
/// <param name="sender">Sends the poses.</param>
/// <param name="reader">Receives the poses.</param>
/// <param name="name">The destination, for the user.</param>
/// <param name="avatar">Says which avatar the destination gets; null for any.</param>
internal sealed class PoseOutlet(PoseSender sender, NeuronReader reader, string name, NamedAvatar? avatar) : Outlet
{
    private static readonly OutletNote NoReceiver = new("refused", "no program receives on that port");

    private long _refusals;

    public override string Name => name;

    public override string Announcement => $"Sending poses to {name}";

    public override string Noun => "pose";

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
            Skipped = statistics.FramesSkipped,
            Note = isRefused ? NoReceiver : DescribeMissing(),
        };
    }

    // A name that is mistyped looks like a performer who is not there yet.
    private OutletNote? DescribeMissing()
    {
        if (avatar is null)
            return null;

        AvatarStatistics[] arriving = [.. reader.GetAvatarStatistics().Where(static candidate => candidate is { Kind: PacketKind.Motion, Frames: > 0 })];
        return arriving.Length == 0 || Array.Exists(arriving, avatar.Is) ? null : new OutletNote("unmatched", avatar.DescribeMissing(arriving));
    }

    // A receiver that is off is no fault of the relay.
    public override async Task<bool> FinishAsync(StandardStreams streams)
    {
        await Task.WhenAny(sender.Completion);
        return true;
    }

    public override ValueTask DisposeAsync() => sender.DisposeAsync();
}
