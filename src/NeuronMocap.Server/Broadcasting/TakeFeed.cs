namespace NeuronMocap.Server.Broadcasting;

/// <summary>The whole take from frame 0 for one recipient, computed as the recipient reads.</summary>
/// <remarks>
/// This is possible because sources are pure functions of the frame number. The recipient sets the pace and misses no frame.
/// </remarks>
internal sealed class TakeFeed(FramePlan plan) : FrameFeed
{
    private readonly FrameEncoder _encoder = plan.CreateEncoder();
    private long _position;

    public override bool IsLive => false;

    public override bool IsAtEnd => _position == plan.FrameCount;

    public override long MissedPackets => 0;

    public override FrameBatch Read(Span<byte> destination)
    {
        int written = 0;
        int frames = 0;
        while (_position < plan.FrameCount && destination.Length - written >= plan.MaxFrameSize)
        {
            written += _encoder.Encode(_position, destination[written..]);
            frames++;
            _position++;
        }

        return new FrameBatch(written, frames * plan.PacketsPerFrame);
    }
}
