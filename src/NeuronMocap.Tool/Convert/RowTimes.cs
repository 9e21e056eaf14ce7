using NeuronMocap.Timing;

namespace NeuronMocap.Tool.Convert;

/// <summary>The arrival times and frame numbers of one avatar. They give the rate of rows that have no times.</summary>
internal sealed class RowTimes
{
    private readonly FrameTiming _timing = new();
    private readonly List<uint?> _indices = [];
    private long _rows;

    public double? Rate => _timing.Rate;

    /// <summary>The time of the last row.</summary>
    public TimeSpan End { get; private set; }

    /// <summary>The first row in the requested part, and the number of rows to the last one in it.</summary>
    public (long First, long Count) Part { get; private set; }

    /// <summary>Adds the next row. Rows outside the part count for the rate only.</summary>
    public void Add(uint? index, TimeSpan time, int connection, bool isInPart)
    {
        _timing.Add(index, time, connection);
        End = time;
        if (isInPart)
        {
            long first = Part.Count == 0 ? _rows : Part.First;
            Part = (first, _rows - first + 1);
            _indices.Add(index);
        }

        _rows++;
    }

    /// <summary>Counts the gaps in the part. A restart of the server's numbers is a gap of unknown length.</summary>
    public (long Gaps, long MissingFrames) CountGaps()
    {
        (long gaps, long missing) = (0, 0);
        for (int i = 1; i < _indices.Count; i++)
        {
            long? frames = _timing.FramesBetween(_indices[i - 1], _indices[i]);
            gaps += frames == 1 ? 0 : 1;
            missing += (frames - 1) ?? 0;
        }

        return (gaps, missing);
    }
}
