namespace NeuronMocap.Server.Broadcasting;

/// <summary>
/// The whole take from frame 0 for one recipient, computed as it asks: possible because sources are pure functions of the frame number.
/// Its reader is its clock, and nothing is lost.
/// </summary>
internal sealed class TakeFeed(FramePlan plan) : FrameFeed
{
    private readonly FrameEncoder _encoder = new(plan);
    private long _position;

    public override bool IsLive => false;

    public override bool IsAtEnd => _position == plan.FrameCount;

    public override long MissedFrames => 0;

    public override int Read(Span<byte> destination)
    {
        int written = 0;
        while (_position < plan.FrameCount && destination.Length - written >= plan.FrameSize)
        {
            _encoder.Encode(_position, destination.Slice(written, plan.FrameSize));
            written += plan.FrameSize;
            _position++;
        }

        return written;
    }
}
