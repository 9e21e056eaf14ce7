using NeuronMocap.Timing;

namespace NeuronMocap.Tool.Convert;

/// <summary>The arrival times and frame numbers of one avatar. They give the rate of rows that have no times.</summary>
internal sealed class RowTimes
{
    private readonly FrameTiming _timing = new();
    private readonly List<uint?> _indices = [];

    public double? Rate => _timing.Rate;

    public void Add(uint? index, TimeSpan time, int connection)
    {
        _timing.Add(index, time, connection);
        _indices.Add(index);
    }

    /// <summary>Counts the gaps. A restart of the server's numbers is a gap of unknown length.</summary>
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
