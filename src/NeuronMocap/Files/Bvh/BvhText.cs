using NeuronMocap.Protocol;
using static NeuronMocap.Bvh.BvhWord;

namespace NeuronMocap.Bvh;

// Walks the bytes of a file word by word and knows the place of each. A line ends with CRLF, LF or CR; words are parted by whatever ASCII calls
// white space. The text lies in memory as a whole, or comes from a stream in pieces of any size, of which a window is kept: then the words
// that are handed out are gone with the next one. No strings are made, save for what is shown to people.
internal ref struct BvhText
{
    /// <summary>Bytes of a word that are looked at as one; what a longer one has beyond is a word of its own.</summary>
    public const int LongestWord = 1 << 16;

    private readonly BvhTextSource? _source;
    private ReadOnlySpan<byte> _window;
    private int _position;
    private Cursor _cursor;
    private long _firstOnLine;

    public BvhText(ReadOnlySpan<byte> text)
    {
        _window = text;
        _cursor = Cursor.Start;
    }

    /// <summary>Goes on where the source's cursor is; <see cref="Save"/> puts it where this has come to.</summary>
    public BvhText(BvhTextSource source)
    {
        _source = source;
        _cursor = source.Cursor;
        _window = source.Window;
        _position = (int)(_cursor.Offset - _cursor.WindowStart);
    }

    /// <summary>The next byte's.</summary>
    public readonly BvhTextPosition Place => new(_cursor.Line, (int)Math.Min(int.MaxValue, Offset - _cursor.LineStart + 1));

    /// <summary>How the first line ended; null while it has not.</summary>
    public readonly string? LineEnd => _cursor.LineEnd;

    /// <summary>The last byte of the space that was skipped, where there was any.</summary>
    public byte LastBlank { get; private set; }

    /// <summary>Whether only blanks stand before the next word on its line. Known once the space before it is skipped.</summary>
    public readonly bool IsFirstOnLine => Offset == _firstOnLine;

    /// <summary>Bytes that are not read yet; null when the stream does not know its end.</summary>
    public readonly long? Remaining => _window.Length - _position + (_source is null ? 0 : _source.Remaining);

    private readonly long Offset => _cursor.WindowStart + _position;

    public readonly void Save() => _source!.Cursor = _cursor with { Offset = Offset };

    /// <summary>At the start of a file: whether there is a byte order mark, which is no text.</summary>
    public bool TrySkipByteOrderMark()
    {
        if (!IsNext([0xEF, 0xBB, 0xBF]))
            return false;

        _position += 3;
        _cursor.LineStart = Offset;
        return true;
    }

    /// <summary>Goes to the next word, on this line or another.</summary>
    /// <returns>False at the end.</returns>
    public bool SkipSpace()
    {
        long start = Offset;
        while (_position < _window.Length || Fill())
        {
            byte next = _window[_position];
            if (!IsSpace(next))
            {
                if (start <= _cursor.LineStart)
                    _firstOnLine = Offset;

                return true;
            }

            LastBlank = next;
            if (next is (byte)'\r' or (byte)'\n')
                SkipLineEnd();
            else
                _position++;
        }

        return false;
    }

    /// <summary>The next word, without going past it, so that the place is still the word's; empty at the end. A brace is a word.</summary>
    public ReadOnlySpan<byte> PeekWord()
    {
        if (!SkipSpace())
            return default;

        return IsBrace(_window[_position]) ? _window.Slice(_position, 1) : PeekUntil(static letter => IsSpace(letter) || IsBrace(letter), LongestWord);
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
    /// <returns>False when it is longer than the longest word; then nothing is read.</returns>
    public bool TryReadToBrace(out ReadOnlySpan<byte> text)
    {
        ReadBlanks();
        text = PeekUntil(static letter => IsLineEnd(letter) || IsBrace(letter), LongestWord + 1);
        if (text.Length > LongestWord)
            return false;

        _position += text.Length;
        text = Trim(text);
        return true;
    }

    public void SkipToBrace() => Skip(static letter => IsLineEnd(letter) || IsBrace(letter));

    public void SkipLine() => Skip(IsLineEnd);

    /// <summary>Goes past the space on this line.</summary>
    /// <returns>The first bytes of it.</returns>
    public ReadOnlySpan<byte> ReadBlanks()
    {
        ReadOnlySpan<byte> blanks = PeekUntil(static letter => !IsSpace(letter) || IsLineEnd(letter), BvhTextFormat.LongestBlanks);
        _position += blanks.Length;
        if (blanks.Length == BvhTextFormat.LongestBlanks)
            Skip(static letter => !IsSpace(letter) || IsLineEnd(letter));

        return blanks;
    }

    /// <summary>The next word of this line, without going past it; empty where the line has no more. Braces are letters like others.</summary>
    public ReadOnlySpan<byte> PeekLineWord()
    {
        Skip(static letter => !IsSpace(letter) || IsLineEnd(letter));
        return PeekUntil(IsSpace, LongestWord);
    }

    /// <summary>Goes past the space on this line; true when nothing more is on it.</summary>
    public bool IsAtLineEnd()
    {
        Skip(static letter => !IsSpace(letter) || IsLineEnd(letter));
        return (_position == _window.Length && !Fill()) || IsLineEnd(_window[_position]);
    }

    /// <summary>Goes past bytes that were peeked.</summary>
    public void Advance(int count) => _position += count;

    /// <summary>Goes past a keyword and the space after it, if the next bytes are it, in any case; what follows may touch it.</summary>
    public bool TryRead(ReadOnlySpan<byte> keyword)
    {
        if (!IsNext(keyword))
            return false;

        _position += keyword.Length;
        Skip(static letter => !IsSpace(letter) || IsLineEnd(letter));
        return true;
    }

    /// <summary>Reads numbers of this line until there is no more room, the line ends, or something else than a number comes next.</summary>
    /// <param name="values">Where they go.</param>
    /// <param name="notFinite">Set to the place of the first one that is not finite, unless it is set already.</param>
    /// <returns>How many were read.</returns>
    public int ReadNumbers(Span<float> values, ref BvhTextPosition notFinite)
    {
        for (int count = 0; count < values.Length; count++)
        {
            while (_position < _window.Length && _window[_position] is (byte)' ' or (byte)'\t')
                _position++;

            if (TextNumber.TryParsePlain(_window[_position..], out values[count], out int length))
            {
                _position += length;
                continue;
            }

            ReadOnlySpan<byte> word = PeekLineWord();
            if (word.Length is 0 or LongestWord || !TextNumber.TryParse(word, out values[count]))
                return count;
            if (notFinite == default && !float.IsFinite(values[count]))
                notFinite = Place;

            _position += word.Length;
        }

        return values.Length;
    }

    private bool IsNext(ReadOnlySpan<byte> keyword)
    {
        for (int i = 0; i < keyword.Length; i++)
        {
            if ((_position + i == _window.Length && !Fill()) || ToLower(_window[_position + i]) != ToLower(keyword[i]))
                return false;
        }

        return true;
    }

    // Reads on only where the end is not there yet: a word whose end has come is not kept waiting for what follows it.
    private ReadOnlySpan<byte> PeekUntil(Predicate<byte> isEnd, int most)
    {
        for (int length = 0; ; length++)
        {
            if (length == most || (_position + length == _window.Length && !Fill()) || isEnd(_window[_position + length]))
                return _window.Slice(_position, length);
        }
    }

    private void Skip(Predicate<byte> isEnd)
    {
        while ((_position < _window.Length || Fill()) && !isEnd(_window[_position]))
            _position++;
    }

    private void SkipLineEnd()
    {
        bool isReturn = _window[_position++] == '\r';
        if (_cursor.Line == 1)
            _cursor.LineEnd = isReturn ? "\r" : "\n";
        if (_cursor.Line < int.MaxValue)
            _cursor.Line++;

        _cursor.LineStart = Offset;
        _cursor.IsAfterReturn = isReturn;
        if (isReturn && _position < _window.Length)
            SkipLineFeed();
    }

    // The second half of CR LF, which may come with a later piece.
    private void SkipLineFeed()
    {
        _cursor.IsAfterReturn = false;
        if (_window[_position] != '\n')
            return;

        _position++;
        _cursor.LineStart = Offset;
        if (_cursor.Line == 2)
            _cursor.LineEnd = "\r\n";
    }

    private bool Fill()
    {
        do
        {
            if (_source is null or { IsEnded: true })
                return false;

            int forgotten = _source.Fill(_position);
            _cursor.WindowStart += forgotten;
            _position -= forgotten;
            _window = _source.Window;
            if (_source.IsEnded)
                return false;
            if (_cursor.IsAfterReturn)
                SkipLineFeed();
        }
        while (_position == _window.Length);
        return true;
    }

    /// <summary>Where a text is read, and what of it has to be known to go on.</summary>
    public struct Cursor
    {
        public long WindowStart;
        public long Offset;
        public long LineStart;
        public int Line;
        public bool IsAfterReturn;
        public string? LineEnd;

        public static Cursor Start => new() { Line = 1 };
    }
}
