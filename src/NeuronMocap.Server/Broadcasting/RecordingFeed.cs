namespace NeuronMocap.Server.Broadcasting;

/// <summary>The whole recording for one recipient, as fast as it asks.</summary>
internal sealed class RecordingFeed(RecordedUnits units, int maxFrameSize, bool isLooped, bool isSingle) : FrameFeed
{
    private bool _isAtEnd;

    public override bool IsLive => false;

    public override bool IsAtEnd => _isAtEnd;

    public override long MissedFrames => 0;

    public override FrameBatch Read(Span<byte> destination)
    {
        int written = 0;
        int frames = 0;
        int most = isSingle ? 1 : int.MaxValue;
        while (!_isAtEnd && frames < most && destination.Length - written >= maxFrameSize)
        {
            if (units.TryRead(out ReadOnlySpan<byte> unit, out _))
            {
                unit.CopyTo(destination[written..]);
                written += unit.Length;
                frames++;
            }
            else if (isLooped)
            {
                units.Rewind();
            }
            else
            {
                _isAtEnd = true;
                units.Dispose();
            }
        }

        return new FrameBatch(written, frames);
    }

    public override void Close() => units.Dispose();
}
