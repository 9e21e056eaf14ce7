using NeuronMocap.Protocol;
using NeuronMocap.Transport;

namespace NeuronMocap.Recording;

// Reads the bytes of a TCP stream from a file without times. They are returned packet by packet. Bytes that are not a packet come with the packet
// that follows them. All packets of one instant, one for each avatar and kind, come at once. The instants have an even rate.
internal sealed class RawDumpSource : RecordedEventSource
{
    private const double UsualRate = 120;
    private const int ChunkSize = 64 * 1024;

    private readonly Stream _file;
    private readonly RawDumpIndex _index;
    private readonly double _rate;
    private byte[] _buffer = new byte[ChunkSize];
    private bool _isOpened;
    private int _next;

    private RawDumpSource(string path, Stream file, RawDumpIndex index, double? rate)
        : base(path)
    {
        _file = file;
        _index = index;
        _rate = rate ?? index.FrameRate ?? UsualRate;
    }

    // Frames per second of each avatar.
    public double FrameRate => _rate;

    // Includes the last interval, so a loop continues at the same rate.
    public override TimeSpan Duration => TimeOf(_index.InstantCount);

    // Reads the file once to find the packets.
    public static RawDumpSource Open(string path, Stream file, PlaybackOptions options)
    {
        var index = new RawDumpIndex();
        var assembler = new PacketAssembler(new PacketScanner(options.MaxValues ?? ProtocolConstants.DefaultMaxValues), index);
        byte[] chunk = new byte[ChunkSize];
        int count;
        while ((count = file.Read(chunk, 0, chunk.Length)) > 0)
            assembler.Push(new ArraySegment<byte>(chunk, 0, count), timestamp: 0);

        assembler.Abandon();
        index.End();
        return index.InstantCount > 0 ? new RawDumpSource(path, file, index, options.FrameRate) : throw NothingFound(path, file, index.Skipped);
    }

    public override RecordedEvent Read()
    {
        if (!_isOpened)
        {
            _isOpened = true;
            return new RecordedEvent(RecordedEventKind.Opened, TimeSpan.Zero);
        }

        if (_next == _index.PieceCount)
            return new RecordedEvent(RecordedEventKind.End, Duration);

        long start = _index.EndOf(_next - 1);
        int length = (int)(_index.EndOf(_next) - start);
        if (_buffer.Length < length)
            _buffer = new byte[Math.Max(length, 2 * _buffer.Length)];

        ReadExactly(start, length);
        TimeSpan time = TimeOf(_index.InstantOf(_next++));
        return new RecordedEvent(RecordedEventKind.Bytes, time) { Bytes = new ArraySegment<byte>(_buffer, 0, length) };
    }

    public override bool Seek(TimeSpan time)
    {
        _next = _index.FindInstant((int)Math.Clamp(Math.Floor(time.TotalSeconds * _rate), 0, int.MaxValue));
        _isOpened = _next > 0;
        return _next == 0;
    }

    public override void Dispose() => _file.Dispose();

    private TimeSpan TimeOf(int instant) => TimeSpan.FromTicks((long)(instant * (TimeSpan.TicksPerSecond / _rate)));

    private void ReadExactly(long start, int length)
    {
        if (_file.Position != start)
            _file.Position = start;

        int filled = 0;
        while (filled < length)
        {
            int count = _file.Read(_buffer, filled, length - filled);
            if (count == 0)
                throw new EndOfStreamException($"'{FilePath}' has become shorter since it was opened.");

            filled += count;
        }
    }

    private static PlaybackException NothingFound(string path, Stream file, SkipReason skipped)
    {
        byte[] start = new byte[64];
        file.Position = 0;
        ReadOnlySpan<byte> bytes = start.AsSpan(0, file.Read(start, 0, start.Length));
        if (bytes.IsEmpty)
            return new PlaybackException($"'{path}' is empty.");
        if (bytes.IndexOf("HIERARCHY"u8) >= 0)
            return new PlaybackException($"'{path}' is a BVH file, not a recording of a stream.");

        var guess = FormatGuess.Of(bytes, skipped);
        return new PlaybackException(guess.Format is ForeignFormat.Unknown or ForeignFormat.OtherProgram
            ? $"'{path}' is neither a recording nor a dump of a stream: it does not contain a frame, and starts with {FormatGuess.ToHex(bytes)}."
            : $"'{path}' does not contain a frame: it is {guess.Description}");
    }
}
