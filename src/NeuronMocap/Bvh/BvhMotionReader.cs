using NeuronMocap.Protocol;

namespace NeuronMocap.Bvh;

/// <summary>
/// Reads from MOTION to the end, line by line. Rows are counted, whatever the file announces, so memory follows the length of the file.
/// <para>
/// Several MOTION blocks are one take, in the order of the file: they share the hierarchy, and leaving one out would lose what it holds.
/// The first usable frame time counts. A line with too few values is joined with those below it if together they make whole rows; else it
/// is left out, since a pose with invented values is worse than a missing one.
/// </para>
/// </summary>
internal ref struct BvhMotionReader
{
    private readonly BvhRepairLog _repairs;
    private readonly int _channelCount;
    private readonly int _mostValues;
    private BvhText _text;
    private int _line;

    // Up to _rowEnd the values are those of whole rows; from there to _valueEnd those of lines that may still become one.
    private float[] _values = [];
    private int _rowEnd;
    private int _valueEnd;
    private int _openLine;

    private int _blockLine;
    private int _blockStart;
    private int _framesLine;
    private double _frames;
    private ReadOnlySpan<byte> _framesWord;

    public BvhMotionReader(BvhText text, int channelCount, BvhRepairLog repairs)
    {
        _text = text;
        _channelCount = channelCount;
        _repairs = repairs;
        _mostValues = (text.Remaining / 2) + 1;
    }

    /// <summary>Seconds as the file has it; 0 when it has none.</summary>
    public double DeclaredFrameTime { get; private set; }

    public BvhFrameTime FrameTime { get; private set; } = BvhFrameTime.Default;

    /// <summary>The values of whole rows, one row after the other.</summary>
    public readonly float[] Values => _values;

    public void Read()
    {
        if (_text.PeekWord().IsEmpty)
            return;

        _line = _text.Line;
        int start = _line;
        if (!_text.TryReadWord("MOTION"u8))
            _repairs.Add(_line, "The word MOTION is missing; it is read as if it stood here.");

        BeginBlock();
        while (_text.Remaining > 0 && TryReadLine())
        {
        }

        EndBlock();
        Array.Resize(ref _values, _rowEnd);
        if (DeclaredFrameTime == 0)
            _repairs.Add(start, "There is no usable frame time; 120 Hz is assumed.");
    }

    private bool TryReadLine()
    {
        _line = _text.Line;
        ReadOnlySpan<byte> line = _text.ReadLine();
        if (BvhText.StartsWith(line, "HIERARCHY"u8))
        {
            _repairs.Add(_line, "A second HIERARCHY begins here; neither it nor anything after it is read.");
            return false;
        }

        while (TryReadHeading(ref line))
            line = BvhText.Trim(line);

        if (!line.IsEmpty)
            ReadRow(line);

        return true;
    }

    private bool TryReadHeading(scoped ref ReadOnlySpan<byte> line)
    {
        if (TryTake(ref line, "MOTION"u8))
        {
            EndBlock();
            BeginBlock();
            _repairs.Add(_line, "A further MOTION begins here; its rows follow those before it.");
            return true;
        }

        if (TryTake(ref line, "Frames"u8))
        {
            ReadFrames(TakeValue(ref line));
            return true;
        }

        if (!TryTake(ref line, "Frame"u8))
            return false;

        TryTake(ref line, "Time"u8);
        ReadFrameTime(TakeValue(ref line));
        return true;
    }

    private static ReadOnlySpan<byte> TakeValue(scoped ref ReadOnlySpan<byte> line)
    {
        TryTake(ref line, ":"u8);
        return BvhText.TakeWord(ref line);
    }

    private static bool TryTake(scoped ref ReadOnlySpan<byte> line, ReadOnlySpan<byte> keyword)
    {
        if (!BvhText.StartsWith(line, keyword))
            return false;

        line = BvhText.Trim(line[keyword.Length..]);
        return true;
    }

    private void BeginBlock()
    {
        _blockLine = _line;
        _blockStart = _rowEnd;
        _framesLine = 0;
    }

    private void EndBlock()
    {
        LeaveOutOpenLines();
        int rows = _channelCount == 0 ? 0 : (_rowEnd - _blockStart) / _channelCount;
        if (_framesLine == 0)
            _repairs.Add(_blockLine, $"The number of frames is missing; {rows} are there.");
        else if (_frames != rows)
            _repairs.Add(_framesLine, $"{BvhText.Quote(_framesWord)} frames are announced and {rows} rows are there; the rows count.");
    }

    private void ReadFrames(ReadOnlySpan<byte> word)
    {
        LeaveOutOpenLines();
        if (_framesLine != 0)
        {
            _repairs.Add(_line, "A further number of frames is ignored.");
            return;
        }

        _framesLine = _line;
        _framesWord = word;
        _frames = TextNumber.TryParse(word, out double frames, out _) ? frames : -1;
    }

    private void ReadFrameTime(ReadOnlySpan<byte> word)
    {
        LeaveOutOpenLines();
        if (!BvhFrameTimeText.TryParse(word, out double declared, out BvhFrameTime time))
        {
            _repairs.Add(_line, $"{BvhText.Quote(word)} is not a frame time; it is ignored.");
        }
        else if (DeclaredFrameTime == 0)
        {
            DeclaredFrameTime = declared;
            FrameTime = time;
        }
        else if (declared != DeclaredFrameTime)
        {
            _repairs.Add(_line, $"A further frame time, {BvhText.Quote(word)}, is ignored.");
        }
    }

    private void ReadRow(ReadOnlySpan<byte> line)
    {
        if (_channelCount == 0)
        {
            _repairs.Add(_line, "The joints have no channels; the line is left out.");
            return;
        }

        int start = _valueEnd;
        bool isFinite = true;
        ReadOnlySpan<byte> word = BvhText.TakeWord(ref line);
        for (; !word.IsEmpty; word = BvhText.TakeWord(ref line))
        {
            if (!TextNumber.TryParse(word, out float value))
            {
                _valueEnd = start;
                LeaveOutOpenLines();
                _repairs.Add(_line, $"{BvhText.Quote(word)} is not a number; the line is left out.");
                return;
            }

            isFinite &= float.IsFinite(value);
            Append(value);
        }

        if (!isFinite)
            _repairs.Add(_line, "Some values are not finite; they are read as they stand.");

        EndLine(start);
    }

    private void EndLine(int start)
    {
        bool isJoined = start > _rowEnd;
        _openLine = isJoined ? _openLine : _line;
        int count = _valueEnd - _rowEnd;
        if (count < _channelCount)
            return;

        if (count % _channelCount == 0)
        {
            if (isJoined || count > _channelCount)
                _repairs.Add(_openLine, $"The values from here to line {_line} make {count / _channelCount} rows and are read as such.");

            _rowEnd = _valueEnd;
        }
        else if (isJoined)
        {
            ReadOnlySpan<float> last = _values.AsSpan(start, _valueEnd - start);
            _valueEnd = start;
            LeaveOutOpenLines();
            last.CopyTo(_values.AsSpan(_rowEnd));
            _valueEnd = _rowEnd + last.Length;
            EndLine(_rowEnd);
        }
        else
        {
            _repairs.Add(_line, $"A row has {count} values instead of {_channelCount}; the first {_channelCount} are read.");
            _rowEnd += _channelCount;
            _valueEnd = _rowEnd;
        }
    }

    private void LeaveOutOpenLines()
    {
        int count = _valueEnd - _rowEnd;
        if (count > 0)
            _repairs.Add(_openLine, $"A row has {count} values instead of {_channelCount}; it is left out.");

        _valueEnd = _rowEnd;
    }

    private void Append(float value)
    {
        if (_valueEnd == _values.Length)
            Grow();

        _values[_valueEnd++] = value;
    }

    // To what is announced, when the text is long enough to hold that many: two bytes a value.
    private void Grow()
    {
        double wanted = Math.Max(_frames * _channelCount, Math.Max(256, 2.0 * _values.Length));
        Array.Resize(ref _values, (int)Math.Min(wanted, _mostValues));
    }
}
