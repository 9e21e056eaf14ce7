using NeuronMocap.Server;

namespace NeuronMocap.Tool.Convert;

/// <summary>The arrival times and frame numbers of one avatar. They give the rate of rows that have no times.</summary>
internal sealed class RowTimes
{
    private const int LargestReduction = 60;

    private readonly List<(uint? Index, TimeSpan Time)> _rows = [];

    public int Count => _rows.Count;

    public TimeSpan First => _rows[0].Time;

    public void Add(uint? index, TimeSpan time) => _rows.Add((index, time));

    /// <summary>Measures the rate and the gaps.</summary>
    public (double? Rate, long Gaps, long MissingFrames) Measure()
    {
        var estimate = new FrameRateEstimator();
        (long frame, long gaps, long missing) = (0, 0, 0);
        uint reduction = FindReduction();
        for (int i = 0; i < _rows.Count; i++)
        {
            long? step = i == 0 ? null : StepTo(i, reduction);
            if (step is { } known)
            {
                estimate.Add(frame += known, _rows[i].Time);
                gaps += known > 1 ? 1 : 0;
                missing += known - 1;
            }
            else
            {
                estimate.Restart(frame, _rows[i].Time);
                gaps += i > 0 ? 1 : 0;
            }
        }

        return (estimate.FrameRate, gaps, missing);
    }

    // Null if the server restarted its numbers.
    private long? StepTo(int row, uint reduction)
    {
        if (_rows[row - 1].Index is not { } before || _rows[row].Index is not { } index)
            return 1;

        int step = (int)(index - before);
        return step > 0 && step % reduction == 0 && _rows[row].Time >= _rows[row - 1].Time ? step / reduction : null;
    }

    // Finds the most common step. A server may send only every second or third frame.
    private uint FindReduction()
    {
        int[] counts = new int[LargestReduction + 1];
        for (int i = 1; i < _rows.Count; i++)
        {
            if (_rows[i - 1].Index is { } before && _rows[i].Index is { } index && index - before is > 0 and <= LargestReduction and var step)
                counts[(int)step]++;
        }

        int most = counts.Max();
        return most == 0 ? 1 : (uint)Array.IndexOf(counts, most);
    }
}
