using NeuronMocap.Protocol;

namespace NeuronMocap.Recording;

// Finds the ends of the packets in a dump and the instant of each packet. It uses the assembler that later reads the packets.
internal sealed class RawDumpIndex : IPacketReceiver
{
    // Bytes that are not part of a packet become a piece of their own at this length.
    private const int LongestGap = 64 * 1024;

    // Maximum number of frames of one instant. No stream has more avatars. The limit also matters for speed: clearing a set takes time in
    // proportion to its largest size.
    private const int MaxFrames = 1024;

    private readonly List<Piece> _pieces = [];
    private readonly HashSet<(PacketKind Kind, uint Avatar)> _seen = [];
    private readonly TimecodeRate _timecodes = new();
    private long _position;

    public int PieceCount => _pieces.Count;

    // Number of instants with frames.
    public int InstantCount { get; private set; }

    // The most informative reason for skipped bytes.
    public SkipReason Skipped { get; private set; }

    // The rate according to the timecodes; null without timecodes.
    public double? FrameRate => _timecodes.FrameRate;

    public long EndOf(int piece) => piece < 0 ? 0 : _pieces[piece].End;

    public int InstantOf(int piece) => _pieces[piece].Instant;

    // Finds the first piece of an instant, or of the next instant that has pieces. At the end, this is the number of pieces.
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
        // The bytes of a line were already reported.
        if (!packet.IsText)
            _position += packet.Length;
        if (packet.IsFrame)
            CountFrame(packet);

        Cut();
    }

    public void OnText(ReadOnlySpan<byte> bytes, PacketKind kind) => Pass(bytes.Length);

    public void OnSkipped(ReadOnlySpan<byte> bytes, SkipReason reason)
    {
        // The rest of an incomplete first line tells less than the bytes after it.
        if (Skipped is SkipReason.NoTokens)
            Skipped = reason;

        Pass(bytes.Length);
    }

    // Ends the index with the bytes after the last packet.
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

    // Counts instants per second, over whole seconds that follow each other.
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
