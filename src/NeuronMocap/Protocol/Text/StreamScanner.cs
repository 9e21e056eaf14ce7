using System.Runtime.CompilerServices;

namespace NeuronMocap.Protocol;

internal enum StreamPart
{
    // The bytes may start a packet or a line, but are incomplete.
    NeedMoreData,

    // A binary packet.
    Packet,

    // A line of text with a frame. The scanner holds its image.
    Line,

    // Bytes after a line: its line ending, and zero bytes that some servers send.
    Blank,

    Skipped,
}

internal readonly record struct StreamScan(StreamPart Part, int Length, PacketKind Kind = PacketKind.None, SkipReason Reason = default);

// Finds packets and lines of text in one sender's bytes. A line can begin at the start, after a packet or a line, and after a line feed in skipped bytes.
// No byte of a line can start a packet, so neither search waits for the other. The state consists of the kind of the current position, and the number of
// examined bytes of an unfinished line. Any splitting of the same bytes therefore gives the same parts, and bytes that arrive one by one are examined only
// once. Not thread-safe.
internal sealed class StreamScanner(PacketScanner packets)
{
    // Bytes without a line ending within this length are not a line. Even 946 values of 32 characters, each with a space, are shorter.
    public const int LongestLine = 32 * 1024;

    private readonly TextLine _line = new(packets.MaxValues);
    private Place _place = Place.Start;

    // State of the line that may begin at the current position: number of examined bytes, number of started words, and the last character.
    private int _checked;
    private int _words;
    private bool _inWord;
    private byte _last;

    // Number of bytes from the current position in which no packet begins. It is determined once, however many lines are searched for in them.
    private int _clear;

    private enum Place
    {
        // In the middle of skipped bytes: no line begins here.
        Noise,

        // Earlier bytes may be missing: this may be the rest of a line.
        Unsure,
        Start,
        BehindLine,
    }

    public byte[] Image => _line.Image;

    // Whether an unfinished line has passed its first word.
    public bool IsInsideLine => _words > 1 || (_words == 1 && !_inWord);

    public int ImageLength => _line.ImageLength;

    // Number of examined bytes outside binary packets, including repeats. Any noise costs at most a few examinations of each byte.
    public long Examined { get; private set; }

    // The next bytes do not continue the earlier ones, and begin a packet or a line.
    public void Begin()
    {
        _place = Place.Start;
        _clear = 0;
        Forget();
    }

    // The next bytes do not continue the earlier ones, and may begin in the middle of a packet or a line.
    public void Restart()
    {
        _place = Place.Unsure;
        _clear = 0;
        Forget();
    }

    // Takes the usual part, a complete motion packet, as Scan would, but in fewer steps. Returns its length, or 0 if the bytes begin with something else.
    // It need not look at _clear, because no packet begins in such bytes.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public int TakeMotion(ReadOnlySpan<byte> source)
    {
        int length = packets.GetMotionLength(source);
        if (length > 0)
            _place = Place.Start;

        return length;
    }

    public StreamScan Scan(ReadOnlySpan<byte> source)
    {
        if (source.Length > 0 && _place != Place.Noise && !PacketTokens.IsStart(source[0]))
        {
            int blanks = CountBlanks(source);
            if (blanks > 0)
                return PassBlanks(source[..blanks]);
            if (TextAlphabet.MayStartLine(source[0]) && ScanLine(source) is { } line)
                return line;
        }

        return ScanPacket(source);
    }

    // Returns how many more bytes to examine at once: up to the possible end of the unfinished line.
    public int Wanted(ReadOnlySpan<byte> piece, int pending, int needed)
    {
        if (_checked == 0)
            return Math.Min(needed - pending, piece.Length);

        int end = piece.IndexOfAny((byte)'\n', (byte)'|', ProtocolConstants.TokenStart);
        return Math.Min(end < 0 ? piece.Length : end + 1, LongestLine - pending);
    }

    private StreamScan ScanPacket(ReadOnlySpan<byte> source)
    {
        if (_clear > 0)
            return PassNoise(source[..Math.Min(_clear, source.Length)], SkipReason.NoTokens);

        ScanResult result = packets.Scan(source);
        if (result.Status == ScanStatus.NeedMoreData)
            return new StreamScan(StreamPart.NeedMoreData, result.Length);

        if (result.Status == ScanStatus.Packet)
        {
            _place = Place.Start;
            return new StreamScan(StreamPart.Packet, result.Length, result.Kind);
        }

        _clear = result.Length;
        Examined += result.Length;
        return PassNoise(source[..result.Length], result.Reason);
    }

    // Skips to the place where a line may begin.
    private StreamScan PassNoise(ReadOnlySpan<byte> noise, SkipReason reason)
    {
        int lineStart = FindLineStart(noise);
        int length = lineStart < 0 ? noise.Length : lineStart;
        _place = lineStart < 0 ? Place.Noise : Place.Start;
        Examined += length;
        return Skip(length, reason);
    }

    private StreamScan PassBlanks(ReadOnlySpan<byte> blanks)
    {
        Examined += blanks.Length;
        if (_place == Place.BehindLine)
            return Pass(StreamPart.Blank, blanks.Length);

        if (blanks.IndexOf((byte)'\n') >= 0)
            _place = Place.Start;

        return Skip(blanks.Length, SkipReason.NoTokens);
    }

    // Returns null if there is no line.
    private StreamScan? ScanLine(ReadOnlySpan<byte> source)
    {
        int limit = Math.Min(source.Length, LongestLine);
        for (; _checked < limit; _checked++)
        {
            byte letter = source[_checked];
            if (letter == 0)
                continue;

            if (letter == '\n' || (letter == '|' && _last == '|'))
                return EndLine(source[..(_checked + 1)]);

            if (!TakeLetter(letter))
            {
                Examined += _checked;
                Forget();
                _place = Place.Noise;
                return null;
            }

            _last = letter;
        }

        if (limit < LongestLine)
            return new StreamScan(StreamPart.NeedMoreData, source.Length + 1);

        // The last byte may be the first byte of a token.
        Examined += LongestLine;
        Forget();
        _place = Place.Noise;
        return Skip(LongestLine - 1, SkipReason.MalformedLine);
    }

    private bool TakeLetter(byte letter)
    {
        if (TextLine.IsSeparator(letter))
        {
            _inWord = false;
            return true;
        }

        if (!_inWord)
            _words++;

        _inWord = true;
        return TextAlphabet.MayStandInWord(_words, letter, _last);
    }

    private StreamScan EndLine(ReadOnlySpan<byte> line)
    {
        Examined += line.Length;
        PacketKind kind = _line.Read(line, _words, isWhole: _place != Place.Unsure, out SkipReason reason);
        Forget();
        _place = kind == PacketKind.None ? Place.Start : Place.BehindLine;
        return kind == PacketKind.None ? Skip(line.Length, reason) : Pass(StreamPart.Line, line.Length, kind);
    }

    private void Forget()
    {
        _checked = 0;
        _words = 0;
        _inWord = false;
        _last = 0;
    }

    // Returns the place after a line feed where, after optional blanks, a line can begin or the bytes end; -1 if there is no such place.
    private static int FindLineStart(ReadOnlySpan<byte> skipped)
    {
        int at = 0;
        while (skipped[at..].IndexOf((byte)'\n') is >= 0 and var next)
        {
            int start = at + next + 1;
            at = start + CountBlanks(skipped[start..]);
            if (at == skipped.Length || TextAlphabet.MayStartLine(skipped[at]))
                return start;
        }

        return -1;
    }

    private static int CountBlanks(ReadOnlySpan<byte> source)
    {
        int count = 0;
        while (count < source.Length && source[count] is 0 or (byte)' ' or (byte)'\t' or (byte)'\r' or (byte)'\n')
            count++;

        return count;
    }

    private StreamScan Skip(int length, SkipReason reason) => Pass(StreamPart.Skipped, length, reason: reason);

    private StreamScan Pass(StreamPart part, int length, PacketKind kind = PacketKind.None, SkipReason reason = default)
    {
        _clear = Math.Max(0, _clear - length);
        return new StreamScan(part, length, kind, reason);
    }
}
