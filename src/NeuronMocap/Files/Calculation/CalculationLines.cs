namespace NeuronMocap.Calculation;

// Reads the lines of a file, one after the other, in one buffer. A line ends with CR LF, LF or CR. A line longer than any row, as in a file without
// line ends, is returned in pieces.
internal sealed class CalculationLines(Stream stream, IProgress<long>? progress)
{
    private const int LongestLine = 1 << 20;

    private static readonly byte[] ByteOrderMark = [0xEF, 0xBB, 0xBF];

    private byte[] _buffer = new byte[1 << 16];
    private int _start;
    private int _end;
    private int _textLength;
    private int _lineLength;
    private long _taken;
    private bool _isEnded;

    /// <summary>Number of the line, from 1; 0 before the first line is read.</summary>
    public int Number { get; private set; }

    /// <summary>Number of bytes up to the end of the line.</summary>
    public long BytesRead { get; private set; }

    /// <summary>The line without its line end. Valid until the next line is read.</summary>
    public ReadOnlySpan<byte> Text => _buffer.AsSpan(_start, _textLength);

    /// <summary>The line with its line end. The last line of a file may not have one.</summary>
    public ReadOnlySpan<byte> TextAndEnd => _buffer.AsSpan(_start, _lineLength);

    public bool HasEnd => _lineLength > _textLength;

    /// <summary>Removes a byte order mark from the start of the line. Returns it, or nothing.</summary>
    public ReadOnlySpan<byte> TakeByteOrderMark()
    {
        if (!Text.StartsWith(ByteOrderMark))
            return default;

        _start += ByteOrderMark.Length;
        _textLength -= ByteOrderMark.Length;
        _lineLength -= ByteOrderMark.Length;
        return ByteOrderMark;
    }

    public bool TryRead()
    {
        _start += _lineLength;
        _textLength = 0;
        _lineLength = 0;
        int searched = 0;
        while (!TryFindEnd(ref searched))
        {
            if (_isEnded || searched >= LongestLine)
            {
                if (searched == 0)
                    return false;

                _textLength = searched;
                _lineLength = searched;
                break;
            }

            Fill();
        }

        Number++;
        BytesRead += _lineLength;
        return true;
    }

    private bool TryFindEnd(ref int searched)
    {
        ReadOnlySpan<byte> text = _buffer.AsSpan(_start, _end - _start);
        int found = text[searched..].IndexOfAny((byte)'\r', (byte)'\n');
        if (found < 0)
        {
            searched = text.Length;
            return false;
        }

        // If the return is the last byte so far, a line feed may follow.
        searched += found;
        bool isReturn = text[searched] == '\r';
        if (isReturn && searched + 1 == text.Length && !_isEnded)
            return false;

        _textLength = searched;
        _lineLength = searched + (isReturn && searched + 1 < text.Length && text[searched + 1] == '\n' ? 2 : 1);
        return true;
    }

    private void Fill()
    {
        if (_end == _buffer.Length)
        {
            byte[] target = _start > 0 ? _buffer : new byte[2 * _buffer.Length];
            _buffer.AsSpan(_start, _end - _start).CopyTo(target);
            _buffer = target;
            _end -= _start;
            _start = 0;
        }

        int count = stream.Read(_buffer, _end, _buffer.Length - _end);
        _end += count;
        _isEnded = count == 0;
        _taken += count;
        progress?.Report(_taken);
    }
}
