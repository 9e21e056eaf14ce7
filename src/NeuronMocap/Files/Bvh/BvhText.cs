using NeuronMocap.Protocol;
using static NeuronMocap.Bvh.BvhWord;

namespace NeuronMocap.Bvh;

// Reads the bytes of a file word by word, with the position of each word. A line ends with CRLF, LF or CR; ASCII white space separates words. The
// text is completely in memory, or comes from a stream in pieces of any size. For a stream, only a window of the text is kept, and a returned word
// is valid until the next one is read. Strings are created only for messages.
internal ref struct BvhText
{
    /// <summary>Maximum length of a word in bytes. The rest of a longer word becomes a word of its own.</summary>
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

    /// <summary>Continues at the source's cursor. <see cref="Save"/> stores the new position in it.</summary>
    public BvhText(BvhTextSource source)
    {
        _source = source;
        _cursor = source.Cursor;
        _window = source.Window;
        _position = (int)(_cursor.Offset - _cursor.WindowStart);
    }

    /// <summary>The position of the next byte.</summary>
    public readonly BvhTextPosition Place => new(_cursor.Line, (int)Math.Min(int.MaxValue, Offset - _cursor.LineStart + 1));

    /// <summary>The end of the first line; null until it is read.</summary>
    public readonly string? LineEnd => _cursor.LineEnd;

    /// <summary>The last byte of the skipped white space, if there was any.</summary>
    public byte LastBlank { get; private set; }

    /// <summary>Whether only blanks stand before the next word on its line. Valid after the white space before the word is skipped.</summary>
    public readonly bool IsFirstOnLine => Offset == _firstOnLine;

    /// <summary>Number of bytes that are not read yet; null when the length of the stream is unknown.</summary>
    public readonly long? Remaining => _window.Length - _position + (_source is null ? 0 : _source.Remaining);

    private readonly long Offset => _cursor.WindowStart + _position;

    public readonly void Save() => _source!.Cursor = _cursor with { Offset = Offset };

    /// <summary>Skips a byte order mark at the start of a file, if there is one.</summary>
    public bool TrySkipByteOrderMark()
    {
        if (!IsNext([0xEF, 0xBB, 0xBF]))
            return false;

        _position += 3;
        _cursor.LineStart = Offset;
        return true;
    }

    /// <summary>Skips white space up to the next word, on this line or a later one.</summary>
    /// <returns>True if a word follows; false at the end.</returns>
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

    /// <summary>Gets the next word without moving past it; empty at the end. The position remains that of the word. A brace is a word.</summary>
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

    /// <summary>Reads the rest of the line up to a brace, without surrounding white space. The brace or the line end comes next.</summary>
    /// <returns>False if the text is longer than the longest word. In this case, nothing is read.</returns>
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

    /// <summary>Skips the white space on this line.</summary>
    /// <returns>The first bytes of the white space.</returns>
    public ReadOnlySpan<byte> ReadBlanks()
    {
        ReadOnlySpan<byte> blanks = PeekUntil(static letter => !IsSpace(letter) || IsLineEnd(letter), BvhTextFormat.LongestBlanks);
        _position += blanks.Length;
        if (blanks.Length == BvhTextFormat.LongestBlanks)
            Skip(static letter => !IsSpace(letter) || IsLineEnd(letter));

        return blanks;
    }

    /// <summary>Gets the next word of this line without moving past it; empty at the end of the line. Braces do not end the word.</summary>
    public ReadOnlySpan<byte> PeekLineWord()
    {
        Skip(static letter => !IsSpace(letter) || IsLineEnd(letter));
        return PeekUntil(IsSpace, LongestWord);
    }

    /// <summary>Skips the white space on this line. Returns true if the line holds nothing more.</summary>
    public bool IsAtLineEnd()
    {
        Skip(static letter => !IsSpace(letter) || IsLineEnd(letter));
        return (_position == _window.Length && !Fill()) || IsLineEnd(_window[_position]) || (IsPadding(_window[_position]) && IsOnlyPaddingLeft());
    }

    /// <summary>Skips bytes that can follow the end of a text. Returns false if the next byte is none of them.</summary>
    public bool TrySkipPadding()
    {
        if ((_position == _window.Length && !Fill()) || !IsPadding(_window[_position]))
            return false;

        Skip(static letter => !IsPadding(letter));
        return true;
    }

    /// <summary>Moves past bytes that were peeked.</summary>
    public void Advance(int count) => _position += count;

    /// <summary>
    /// Reads a keyword, in any case, and the white space after it, if the keyword comes next. The following text may touch the keyword.
    /// </summary>
    public bool TryRead(ReadOnlySpan<byte> keyword)
    {
        if (!IsNext(keyword))
            return false;

        _position += keyword.Length;
        Skip(static letter => !IsSpace(letter) || IsLineEnd(letter));
        return true;
    }

    /// <summary>Reads numbers of this line until the span is full, the line ends, or something other than a number follows.</summary>
    /// <param name="values">Receives the numbers.</param>
    /// <param name="notFinite">Receives the position of the first number that is not finite, unless it is already set.</param>
    /// <returns>The number of values read.</returns>
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

            ReadOnlySpan<byte> word = PeekNumber();
            if (word.Length is 0 or LongestWord || !TextNumber.TryParse(word, out values[count]))
                return count;
            if (notFinite == default && !float.IsFinite(values[count]))
                notFinite = Place;

            _position += word.Length;
        }

        return values.Length;
    }

    // The last number of a text can touch the bytes after its end.
    private ReadOnlySpan<byte> PeekNumber()
    {
        ReadOnlySpan<byte> word = PeekLineWord();
        if (word.IsEmpty || !IsPadding(word[^1]))
            return word;

        int length = word.Length;
        while (length > 0 && IsPadding(word[length - 1]))
            length--;

        return word[..length];
    }

    // Looks ahead as far as a word can reach.
    private bool IsOnlyPaddingLeft()
    {
        int length = PeekUntil(static letter => !IsPadding(letter) && !IsSpace(letter), LongestWord).Length;
        return length < LongestWord && _position + length == _window.Length;
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

    // Reads more of the stream only while the end of the word is missing. A complete word does not wait for the text that follows it.
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

    // Skips the second half of CR LF, which may arrive with a later piece.
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

    /// <summary>The position in a text, with the state that reading needs to continue.</summary>
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
