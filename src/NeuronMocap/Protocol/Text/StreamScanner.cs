using System.Runtime.CompilerServices;

namespace NeuronMocap.Protocol;

internal enum StreamPart
{
    // The bytes may start something, but not all of it is there.
    NeedMoreData,

    // A binary packet.
    Packet,

    // A line of text that is a frame; its image is the scanner's.
    Line,

    // What stands behind a line: its end, and zero bytes that some servers send.
    Blank,

    Skipped,
}

internal readonly record struct StreamScan(StreamPart Part, int Length, PacketKind Kind = PacketKind.None, SkipReason Reason = default);

// Finds packets and lines of text in one sender's bytes. A line may begin at the start, behind a packet or a line, and behind a line feed in
// what is skipped. No byte of a line can start a packet, so neither ever waits for the other. What is known of the bytes that went by is which
// of these the present position is, and how far an unfinished line has been looked at: any splitting of the same bytes gives the same parts, and
// bytes that drip in one by one are looked at once. Not thread-safe.
internal sealed class StreamScanner(PacketScanner packets)
{
    // Without an end within so many bytes it is no line: 946 values, each of 32 letters with its blank, are shorter.
    public const int LongestLine = 32 * 1024;

    private readonly TextLine _line = new(packets.MaxValues);
    private Place _place = Place.Start;

    // Of the line that may begin at the present position: bytes that were looked at, words that began, and the last letter.
    private int _checked;
    private int _words;
    private bool _inWord;
    private byte _last;

    // Bytes from the present position on in which no packet begins: found once, however many lines are looked for among them.
    private int _clear;

    private enum Place
    {
        // In the middle of what is skipped: no line begins here.
        Noise,

        // Bytes before this may be missing: the rest of a line may stand here.
        Unsure,
        Start,
        BehindLine,
    }

    public byte[] Image => _line.Image;

    // Whether an unfinished line has come further than its first word.
    public bool IsInsideLine => _words > 1 || (_words == 1 && !_inWord);

    public int ImageLength => _line.ImageLength;

    // Bytes of what is no packet that were looked at, those looked at again included. Noise of any kind costs no more than a few looks at each.
    public long Examined { get; private set; }

    // What comes next does not continue what came before, and begins something.
    public void Begin()
    {
        _place = Place.Start;
        _clear = 0;
        Forget();
    }

    // What comes next does not continue what came before, and may be the middle of anything.
    public void Restart()
    {
        _place = Place.Unsure;
        _clear = 0;
        Forget();
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
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

    // How many more bytes to look at once: up to where the unfinished line may end.
    public int Wanted(ReadOnlySpan<byte> piece, int pending, int needed)
    {
        if (_checked == 0)
            return Math.Min(needed - pending, piece.Length);

        int end = piece.IndexOfAny((byte)'\n', (byte)'|', ProtocolConstants.TokenStart);
        return Math.Min(end < 0 ? piece.Length : end + 1, LongestLine - pending);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
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

    // Up to where a line may begin.
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

    // Null where there is no line.
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

        // The last byte may be the first of a token.
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

    // Behind a line feed from which, over blanks, a line may begin, or nothing else has come yet.
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
