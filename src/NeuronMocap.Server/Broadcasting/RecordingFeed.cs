namespace NeuronMocap.Server.Broadcasting;

/// <summary>The whole recording, or its part, for one recipient, as fast as the recipient reads.</summary>
internal sealed class RecordingFeed(RecordingContent content, bool isLooped, bool isSingle) : FrameFeed
{
    private readonly RecordedUnits _units = content.OpenUnits();
    private bool _isAtEnd;
    private bool _hasTaken;

    public override bool IsLive => false;

    public override bool IsAtEnd => _isAtEnd;

    public override long MissedPackets => 0;

    public override FrameBatch Read(Span<byte> destination)
    {
        int written = 0;
        int frames = 0;
        int most = isSingle ? 1 : int.MaxValue;
        while (!_isAtEnd && frames < most && destination.Length - written >= content.MaxFrameSize)
        {
            if (_units.TryRead(out ReadOnlySpan<byte> unit, out _))
            {
                if (!content.Takes(_units.IsCalculation))
                    continue;

                _hasTaken = true;
                unit.CopyTo(destination[written..]);
                written += unit.Length;
                frames++;
            }
            else if (isLooped && _hasTaken)
            {
                _units.Rewind();
            }
            else
            {
                _isAtEnd = true;
                _units.Dispose();
            }
        }

        return new FrameBatch(written, frames);
    }

    public override void Close() => _units.Dispose();
}
