using NeuronMocap.Protocol;

namespace NeuronMocap.Bvh;

// Holds the values of lines that are not exactly one row, until their meaning is known and their rows are taken.
internal sealed class BvhPendingRows(int channelCount, BvhRepairLog repairs)
{
    // If a line has more rows than this, the reader does not wait for its end. Memory therefore stays bounded.
    private const int MaxRows = 8;

    // Whole rows come first, from _taken to _whole. Values of lines that may still become a row follow. The values of the current line start at
    // _line.
    private float[] _values = [];
    private int _taken;
    private int _whole;
    private int _line;
    private int _end;
    private BvhTextPosition _openPlace;
    private BvhTextPosition _linePlace;

    public bool IsAnyOpen => _end > _whole;

    public bool IsLineLong => _end - _line > MaxRows * channelCount;

    public bool TryTake(Span<float> row)
    {
        if (_taken == _whole)
            return false;

        _values.AsSpan(_taken, channelCount).CopyTo(row);
        _taken += channelCount;
        if (_taken == _end)
            Clear();

        return true;
    }

    public void BeginLine(BvhTextPosition place)
    {
        if (!IsAnyOpen)
            _openPlace = place;

        _linePlace = place;
        _line = _end;
    }

    public void Add(ReadOnlySpan<float> values)
    {
        if (_values.Length < _end + values.Length)
            Array.Resize(ref _values, Math.Max(_end + values.Length, 2 * _values.Length));

        values.CopyTo(_values.AsSpan(_end));
        _end += values.Length;
    }

    /// <summary>Decides what the line is, together with the lines before it.</summary>
    public void EndLine(int lastLine)
    {
        bool isJoined = _line > 0;
        if (_end < channelCount)
            return;

        if (_end % channelCount == 0)
        {
            if (isJoined || _end > channelCount)
                repairs.Add(_openPlace, $"The values from here to line {lastLine} make {_end / channelCount} {CountedNoun.Word(_end / channelCount, "row", "rows")}", $"they are read as such");

            _whole = _end;
        }
        else if (isJoined)
        {
            LeaveOutOlder();
            EndLine(lastLine);
        }
        else
        {
            repairs.Add(_linePlace, $"A row has {_end} {CountedNoun.Word(_end, "value", "values")} instead of {channelCount}", $"the first {channelCount} are read");
            _whole = channelCount;
            _end = channelCount;
        }
    }

    /// <summary>Treats the line as whole rows before it has ended. The caller does not add the further rows of the line here.</summary>
    public void EndLongLine()
    {
        LeaveOutOlder();
        repairs.Add(_linePlace, $"More than {MaxRows} rows are on one line", $"every {channelCount} values are read as one");
        _whole = _end;
    }

    /// <summary>Discards this line, which does not hold values, and the open lines before it.</summary>
    public void LeaveOutLine()
    {
        _end = _line;
        LeaveOut();
    }

    /// <summary>Discards the lines that have not become a row.</summary>
    public void LeaveOut()
    {
        if (IsAnyOpen)
            repairs.AddLeftOut(_openPlace, $"A row has {_end} {CountedNoun.Word(_end, "value", "values")} instead of {channelCount}", $"it is skipped");

        Clear();
    }

    private void LeaveOutOlder()
    {
        int older = _line;
        if (older > 0)
            repairs.AddLeftOut(_openPlace, $"A row has {older} {CountedNoun.Word(older, "value", "values")} instead of {channelCount}", $"it is skipped");

        _values.AsSpan(older, _end - older).CopyTo(_values);
        _end -= older;
        _line = 0;
        _openPlace = _linePlace;
    }

    private void Clear()
    {
        _taken = 0;
        _whole = 0;
        _line = 0;
        _end = 0;
    }
}
