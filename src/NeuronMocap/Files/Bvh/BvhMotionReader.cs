using System.Text;
using NeuronMocap.Protocol;
using static NeuronMocap.Bvh.BvhWord;

namespace NeuronMocap.Bvh;

/// <summary>
/// Reads from MOTION to the end, row by row. The rows that exist count, not the declared number.
/// </summary>
/// <remarks>
/// <para>
/// Several MOTION blocks are one take, in the order of the file. They share the hierarchy, and skipping one would lose its motion. The first usable
/// frame time counts.
/// </para>
/// <para>
/// A line with too few values is joined with the lines below it if together they form whole rows. Otherwise it is skipped, because a pose with
/// invented values is worse than a missing one. <see cref="BvhPendingRows"/> holds undecided values and limits their number: a line with very many
/// values is split as it is read.
/// </para>
/// </remarks>
internal sealed class BvhMotionReader(int channelCount, BvhRepairLog repairs, BvhTextFormatBuilder format)
{
    private readonly BvhPendingRows _rows = new(channelCount, repairs);
    private BvhTextPosition _start;
    private bool _isEnded;
    private bool _isFirstRow = true;
    private bool _isInLongLine;
    private bool _isFrameTimeReported;

    private BvhTextPosition _block;
    private long _blockRows;
    private BvhTextPosition _frames;
    private double _announced;
    private string _announcedText = "";

    /// <summary>Seconds as written in the file; 0 when the file has no usable frame time.</summary>
    public double DeclaredFrameTime { get; private set; }

    public BvhFrameTime FrameTime { get; private set; } = BvhFrameTime.Default;

    /// <summary>The first usable declared number of frames; null until one is read.</summary>
    public long? AnnouncedFrames { get; private set; }

    /// <summary>Reads MOTION and the declarations up to the first row.</summary>
    public void Begin(ref BvhText text)
    {
        if (!text.SkipSpace())
        {
            _isEnded = true;
            return;
        }

        _start = text.Place;
        if (text.TryReadWord("MOTION"u8))
            format.HasBlankLineAfterMotion = text.SkipSpace() && text.Place.Line > _start.Line + 1;
        else
            repairs.Add(_start, $"The word MOTION is missing", $"it is added here");

        BeginBlock(_start);
        MoveToRow(ref text);
    }

    /// <summary>Reads the next row.</summary>
    /// <param name="text">The text, from its current position.</param>
    /// <param name="row">Receives as many values as there are channels; undefined when there is no further row.</param>
    /// <returns>False at the end.</returns>
    public bool TryReadRow(ref BvhText text, Span<float> row)
    {
        while (!_isEnded)
        {
            if (_rows.TryTake(row) || (_isInLongLine ? TryReadLongLine(ref text, row) : MoveToRow(ref text) && TryReadLine(ref text, row)))
            {
                _blockRows++;
                return true;
            }
        }

        return false;
    }

    // Reads all declarations. Returns false at the end, or where a second hierarchy begins.
    private bool MoveToRow(ref BvhText text)
    {
        while (MoveToWord(ref text))
        {
            BvhTextPosition place = text.Place;
            if (text.TryRead("HIERARCHY"u8))
            {
                repairs.Add(place, $"A second HIERARCHY begins here", $"neither it nor anything after it is read");
                break;
            }

            if (!TryReadHeading(ref text, place))
                return true;
        }

        EndBlock();
        if (DeclaredFrameTime == 0 && !_isFrameTimeReported)
            repairs.Add(_start, $"There is no usable frame time", $"120 Hz is assumed");

        _isEnded = true;
        return false;
    }

    // Bytes that can follow the end of a text are not a row. If more text follows them, their line is damaged.
    private bool MoveToWord(ref BvhText text)
    {
        while (text.SkipSpace())
        {
            BvhTextPosition place = text.Place;
            if (!text.TrySkipPadding())
                return true;

            bool isInLine;
            do
            {
                isInLine = !text.IsAtLineEnd();
            }
            while (text.SkipSpace() && text.TrySkipPadding());
            if (!text.SkipSpace())
                return false;

            _rows.LeaveOut();
            repairs.AddLeftOut(place, $"A control character is not a number", $"the line is skipped");
            if (isInLine)
                text.SkipLine();
        }

        return false;
    }

    private bool TryReadHeading(ref BvhText text, BvhTextPosition place)
    {
        if (text.TryRead("MOTION"u8))
        {
            EndBlock();
            BeginBlock(place);
            repairs.Add(place, $"Another MOTION begins here", $"its rows follow those before it");
            return true;
        }

        if (text.TryRead("Frames"u8))
        {
            text.TryRead(":"u8);
            ReadFrames(ref text, place);
            return true;
        }

        if (!text.TryRead("Frame"u8))
            return false;

        text.TryRead("Time"u8);
        text.TryRead(":"u8);
        ReadFrameTime(ref text);
        return true;
    }

    private void BeginBlock(BvhTextPosition place)
    {
        _block = place;
        _blockRows = 0;
        _frames = default;
    }

    private void EndBlock()
    {
        _rows.LeaveOut();
        if (_frames == default)
            repairs.Add(_block, $"The number of frames is missing", $"rows found: {_blockRows}");
        else if (_announced != _blockRows)
            repairs.Add(_frames, $"The file declares {_announcedText} {CountedNoun.Word(_announced, "frame", "frames")} but has {_blockRows} {CountedNoun.Word(_blockRows, "row", "rows")}", $"all rows are read");
    }

    private void ReadFrames(ref BvhText text, BvhTextPosition place)
    {
        _rows.LeaveOut();
        ReadOnlySpan<byte> word = text.PeekLineWord();
        if (_frames == default)
        {
            _frames = word.IsEmpty ? place : text.Place;
            _announcedText = Quote(word);
            _announced = TextNumber.TryParse(word, out double frames, out _) ? frames : -1;
            if (_announced is >= 0 and < long.MaxValue)
                AnnouncedFrames ??= (long)_announced;
        }
        else
        {
            repairs.Add(place, $"The number of frames is declared again", $"it is ignored");
        }

        text.Advance(word.Length);
    }

    private void ReadFrameTime(ref BvhText text)
    {
        _rows.LeaveOut();
        ReadOnlySpan<byte> word = text.PeekLineWord();
        if (!BvhFrameTimeText.TryParse(word, out double declared, out BvhFrameTime time))
        {
            if (_isFrameTimeReported)
                repairs.Add(text.Place, $"{word} is not a frame time", $"it is ignored");
            else
                repairs.Add(text.Place, $"{word} is not a frame time", $"120 Hz is assumed unless a valid one follows");

            _isFrameTimeReported = true;
        }
        else if (DeclaredFrameTime == 0)
        {
            _isFrameTimeReported = true;
            DeclaredFrameTime = declared;
            FrameTime = time;
            format.FrameTimeText = Encoding.ASCII.GetString(word);
        }
        else if (declared != DeclaredFrameTime)
        {
            repairs.Add(text.Place, $"Another frame time is given, {word}", $"it is ignored");
        }

        text.Advance(word.Length);
    }

    private bool TryReadLine(ref BvhText text, Span<float> row)
    {
        BvhTextPosition start = text.Place;
        if (channelCount == 0)
        {
            repairs.AddLeftOut(start, $"The joints have no channels", $"the line is skipped");
            text.SkipLine();
            return false;
        }

        BvhTextPosition notFinite = default;
        int count = _isFirstRow ? ReadFirstRow(ref text, row, ref notFinite) : text.ReadNumbers(row, ref notFinite);
        bool isWhole = count == channelCount && text.IsAtLineEnd();
        if (isWhole && !_rows.IsAnyOpen)
        {
            ReportNotFinite(notFinite);
            return true;
        }

        _rows.BeginLine(start);
        _rows.Add(row[..count]);
        while (count == channelCount && !isWhole && !_rows.IsLineLong)
        {
            count = text.ReadNumbers(row, ref notFinite);
            _rows.Add(row[..count]);
            isWhole = text.IsAtLineEnd();
        }

        if (!text.IsAtLineEnd() && count < channelCount)
        {
            _rows.LeaveOutLine();
            ReportNoNumber(ref text);
            return false;
        }

        ReportNotFinite(notFinite);
        _isInLongLine = !text.IsAtLineEnd();
        if (_isInLongLine)
            _rows.EndLongLine();
        else
            _rows.EndLine(text.Place.Line);

        return false;
    }

    // Continues a line whose rows are returned before the end of the line is known.
    private bool TryReadLongLine(ref BvhText text, Span<float> row)
    {
        bool isAtEnd = text.IsAtLineEnd();
        BvhTextPosition start = text.Place;
        BvhTextPosition notFinite = default;
        int count = isAtEnd ? 0 : text.ReadNumbers(row, ref notFinite);
        ReportNotFinite(notFinite);
        if (count == channelCount)
            return true;

        _isInLongLine = false;
        if (count > 0)
            repairs.AddLeftOut(start, $"A row has {count} {CountedNoun.Word(count, "value", "values")} instead of {channelCount}", $"it is skipped");
        if (!text.IsAtLineEnd())
            ReportNoNumber(ref text);

        return false;
    }

    // Reads word by word to learn the text layout.
    private int ReadFirstRow(ref BvhText text, Span<float> row, ref BvhTextPosition notFinite)
    {
        format.BeginRow();
        for (int count = 0; count < row.Length; count++)
        {
            int decimals = CountDecimals(text.PeekLineWord());
            if (text.ReadNumbers(row.Slice(count, 1), ref notFinite) == 0)
                return count;

            format.AddValue(decimals, text.ReadBlanks());
        }

        _isFirstRow = !text.IsAtLineEnd();
        return row.Length;
    }

    private void ReportNotFinite(BvhTextPosition place)
    {
        if (place != default)
            repairs.Add(place, $"Some values are not finite", $"they are kept");
    }

    private void ReportNoNumber(ref BvhText text)
    {
        ReadOnlySpan<byte> word = text.PeekLineWord();
        if (IsDecimalComma(word))
            repairs.AddLeftOut(text.Place, $"{word} is not a number, because BVH files have decimal points, not commas", $"the line is skipped");
        else
            repairs.AddLeftOut(text.Place, $"{word} is not a number", $"the line is skipped");

        text.SkipLine();
    }
}
