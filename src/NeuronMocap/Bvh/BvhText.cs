using System.Text;

namespace NeuronMocap.Bvh;

// Walks the bytes of a file word by word or line by line and knows the place of each. A line ends with CRLF, LF or CR; words are parted by
// whatever ASCII calls white space. No strings are made, save for what is shown to people.
internal ref struct BvhText
{
    private const int LongestQuote = 40;

    private readonly ReadOnlySpan<byte> _text;
    private int _position;
    private int _lineStart;

    public BvhText(ReadOnlySpan<byte> text)
    {
        ReadOnlySpan<byte> byteOrderMark = [0xEF, 0xBB, 0xBF];
        _text = text.StartsWith(byteOrderMark) ? text[3..] : text;
        Line = 1;
    }

    /// <summary>Line of the next byte, from 1.</summary>
    public int Line { get; private set; }

    /// <summary>Place of the next byte in its line, from 1.</summary>
    public readonly int Column => _position - _lineStart + 1;

    public readonly int Remaining => _text.Length - _position;

    /// <summary>The next word, without going past it, so that the place is still the word's; empty at the end. A brace is a word.</summary>
    public ReadOnlySpan<byte> PeekWord()
    {
        SkipSpace();
        ReadOnlySpan<byte> rest = _text[_position..];
        int length = 0;
        while (length < rest.Length && !IsSpace(rest[length]) && !IsBrace(rest[length]))
            length++;

        return rest[..(length == 0 && rest.Length > 0 ? 1 : length)];
    }

    public ReadOnlySpan<byte> ReadWord()
    {
        ReadOnlySpan<byte> word = PeekWord();
        _position += word.Length;
        return word;
    }

    public bool TryReadWord(ReadOnlySpan<byte> expected)
    {
        if (!AreEqual(PeekWord(), expected))
            return false;

        _position += expected.Length;
        return true;
    }

    /// <summary>What is left of this line up to a brace, without the space around it; the brace or the line end comes next.</summary>
    public ReadOnlySpan<byte> ReadToBrace()
    {
        ReadOnlySpan<byte> rest = _text[_position..];
        int length = rest.IndexOfAny("\r\n{}"u8);
        rest = length < 0 ? rest : rest[..length];
        _position += rest.Length;
        return Trim(rest);
    }

    /// <summary>What is left of this line, without the space around it; the next line comes next. Not to be called at the end.</summary>
    public ReadOnlySpan<byte> ReadLine()
    {
        ReadOnlySpan<byte> rest = _text[_position..];
        int length = rest.IndexOfAny((byte)'\r', (byte)'\n');
        if (length < 0)
        {
            _position = _text.Length;
            return Trim(rest);
        }

        _position += length;
        SkipLineEnd();
        return Trim(rest[..length]);
    }

    /// <summary>Takes the next word off the front of a line; empty when there is none.</summary>
    public static ReadOnlySpan<byte> TakeWord(scoped ref ReadOnlySpan<byte> line)
    {
        int start = 0;
        while (start < line.Length && IsSpace(line[start]))
            start++;

        int end = start;
        while (end < line.Length && !IsSpace(line[end]))
            end++;

        ReadOnlySpan<byte> word = line[start..end];
        line = line[end..];
        return word;
    }

    public static bool AreEqual(ReadOnlySpan<byte> word, ReadOnlySpan<byte> keyword) =>
        word.Length == keyword.Length && StartsWith(word, keyword);

    /// <summary>Compares in any case of the ASCII letters.</summary>
    public static bool StartsWith(ReadOnlySpan<byte> word, ReadOnlySpan<byte> keyword)
    {
        if (word.Length < keyword.Length)
            return false;

        for (int i = 0; i < keyword.Length; i++)
        {
            if (ToLower(word[i]) != ToLower(keyword[i]))
                return false;
        }

        return true;
    }

    public static ReadOnlySpan<byte> Trim(ReadOnlySpan<byte> text)
    {
        while (text.Length > 0 && IsSpace(text[0]))
            text = text[1..];
        while (text.Length > 0 && IsSpace(text[^1]))
            text = text[..^1];

        return text;
    }

    /// <summary>The start of some text, for a message.</summary>
    public static string Quote(ReadOnlySpan<byte> text) =>
        Quote(Encoding.UTF8.GetString(text[..Math.Min(text.Length, LongestQuote)]), isCut: text.Length > LongestQuote);

    /// <summary>The start of some text, for a message.</summary>
    public static string Quote(string text) => Quote(text.AsSpan(0, Math.Min(text.Length, LongestQuote)), isCut: text.Length > LongestQuote);

    private static string Quote(ReadOnlySpan<char> start, bool isCut)
    {
        var quote = new StringBuilder(LongestQuote + 5).Append('\'');
        foreach (char letter in start)
            quote.Append(char.IsControl(letter) ? '?' : letter);

        return quote.Append(isCut ? "...'" : "'").ToString();
    }

    private static byte ToLower(byte letter) => letter is >= (byte)'A' and <= (byte)'Z' ? (byte)(letter | 0x20) : letter;

    private static bool IsSpace(byte letter) => letter == ' ' || (letter >= '\t' && letter <= '\r');

    private static bool IsBrace(byte letter) => letter is (byte)'{' or (byte)'}';

    private void SkipSpace()
    {
        while (_position < _text.Length && IsSpace(_text[_position]))
        {
            if (_text[_position] is (byte)'\r' or (byte)'\n')
                SkipLineEnd();
            else
                _position++;
        }
    }

    private void SkipLineEnd()
    {
        bool two = _text[_position] == '\r' && _position + 1 < _text.Length && _text[_position + 1] == '\n';
        _position += two ? 2 : 1;
        _lineStart = _position;
        Line++;
    }
}
