using NeuronMocap.Protocol;

namespace NeuronMocap.Recording;

// Where the packets of a dump end, and to which instant each belongs: found by the same assembler that will read them.
internal sealed class RawDumpIndex : IPacketReceiver
{
    // Bytes of no packet come on their own when there are so many.
    private const int LongestGap = 64 * 1024;

    // Frames of one instant, at most: nobody has more avatars, and a set is not emptied in less time than it once took to fill.
    private const int MaxFrames = 1024;

    private readonly List<Piece> _pieces = [];
    private readonly HashSet<(PacketKind Kind, uint Avatar)> _seen = [];
    private readonly TimecodeRate _timecodes = new();
    private long _position;

    public int PieceCount => _pieces.Count;

    // Number of instants with frames.
    public int InstantCount { get; private set; }

    // Why bytes were passed over; what says most of them.
    public SkipReason Skipped { get; private set; }

    // As the timecodes tell it; null where there are none.
    public double? FrameRate => _timecodes.FrameRate;

    public long EndOf(int piece) => piece < 0 ? 0 : _pieces[piece].End;

    public int InstantOf(int piece) => _pieces[piece].Instant;

    // The first piece of an instant or, where it has none, of the next one; the number of pieces behind the last.
    public int FindInstant(int instant)
    {
        int low = 0;
        int high = _pieces.Count;
        while (low < high)
        {
            int middle = (low + high) / 2;
            if (_pieces[middle].Instant < instant)
                low = middle + 1;
            else
                high = middle;
        }

        return low;
    }

    public void OnPacket(in ReceivedPacket packet)
    {
        // The bytes of a line were told before it.
        if (!packet.IsText)
            _position += packet.Length;
        if (packet.IsFrame)
            CountFrame(packet);

        Cut();
    }

    public void OnText(ReadOnlySpan<byte> bytes) => Pass(bytes.Length);

    public void OnSkipped(ReadOnlySpan<byte> bytes, SkipReason reason)
    {
        // The rest of a line that was joined late says less than the next one.
        if (Skipped is SkipReason.NoTokens)
            Skipped = reason;

        Pass(bytes.Length);
    }

    // What stands behind the last packet.
    public void End()
    {
        if (_position > EndOf(_pieces.Count - 1))
            Cut();
    }

    private void Pass(int count)
    {
        if (_position - EndOf(_pieces.Count - 1) + count > LongestGap)
            End();

        _position += count;
    }

    private void Cut() => _pieces.Add(new Piece(_position, Math.Max(0, InstantCount - 1)));

    private void CountFrame(in ReceivedPacket packet)
    {
        uint avatar = packet.AvatarIndex;
        if (_seen.Count == MaxFrames || !_seen.Add((packet.Kind, avatar)) || InstantCount == 0)
        {
            _seen.Clear();
            _seen.Add((packet.Kind, avatar));
            InstantCount++;
        }

        if (packet.Kind == PacketKind.Motion && MotionHeader.TryRead(packet.Bytes, out MotionHeader header) && header.Timecode is { } timecode)
            _timecodes.Add(timecode, InstantCount);
    }

    private readonly record struct Piece(long End, int Instant);

    // Instants per second, over the whole seconds that went by one after the other.
    private sealed class TimecodeRate
    {
        private int _second = -1;
        private int _start = -1;
        private long _seconds;
        private long _instants;

        public double? FrameRate => _seconds > 0 ? _instants / (double)_seconds : null;

        public void Add(Timecode code, int instant)
        {
            int second = (((code.Hours * 60) + code.Minutes) * 60) + code.Seconds;
            if (second == _second)
                return;

            bool isNext = second == _second + 1;
            if (isNext && _start >= 0)
            {
                _seconds++;
                _instants += instant - _start;
            }

            _start = _second >= 0 && isNext ? instant : -1;
            _second = second;
        }
    }
}
