using NeuronMocap.Bvh;
using NeuronMocap.Calculation;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Convert;

/// <summary>What convert says at its end, in one line: what the new file holds, what is missing in it, and what is doubtful.</summary>
internal sealed class ConversionSummary
{
    private const int MaxListed = 3;

    private readonly List<string> _warnings = [];
    private readonly List<string> _losses = [];
    private long _moreWarnings;

    /// <summary>Frames of the new file.</summary>
    public long Frames { get; set; }

    /// <summary>Frames per second; null where the file has times of its own, or none.</summary>
    public double? FrameRate { get; set; }

    /// <summary>How long it takes; null where nothing tells.</summary>
    public double? Seconds { get; set; }

    /// <summary>Places of the new file where frames are missing.</summary>
    public long Gaps { get; set; }

    /// <summary>Frames that are missing there.</summary>
    public long MissingFrames { get; set; }

    /// <summary>Frames that were interpolated instead of them.</summary>
    public long InterpolatedFrames { get; set; }

    /// <summary>Rows of the old file that are not in the new one, for they are none.</summary>
    public long RowsLeftOut { get; set; }

    public void AddWarning(string warning) => _warnings.Add(warning.TrimEnd('.'));

    /// <summary>Adds what the old file holds and the new one has no place for.</summary>
    public void AddLoss(string loss) => _losses.Add(loss);

    /// <summary>Adds what was wrong in a BVH file.</summary>
    public void AddRepairs(BvhDocument document)
    {
        RowsLeftOut += document.SkippedRowCount;
        foreach (BvhRepair repair in document.Repairs)
            AddWarning(repair.ToString());

        _moreWarnings += document.RepairCount - document.Repairs.Count;
    }

    /// <summary>Adds what was wrong in a calculation export, once it was read.</summary>
    public void AddRepairs(IReadOnlyList<CalculationRepair> repairs, int count, int leftOut)
    {
        RowsLeftOut += leftOut;
        foreach (CalculationRepair repair in repairs)
            AddWarning(repair.ToString());

        _moreWarnings += count - repairs.Count;
    }

    /// <summary>The line.</summary>
    /// <param name="name">Name of the new file.</param>
    public string Describe(string name)
    {
        string line = $"{name}: {Count(Frames, "frame")}";
        if (Seconds is { } seconds)
            line += Quantity.Format($", {seconds:0.000} s");
        if (FrameRate is { } rate)
            line += Quantity.Format($" at {rate:0.###} Hz");

        line += $"; {Count(Gaps, "gap")}";
        if (MissingFrames > 0)
            line += $" ({Count(MissingFrames, "frame")} missing{(InterpolatedFrames > 0 ? Quantity.Format($", {InterpolatedFrames:#,0} interpolated") : string.Empty)})";

        long warnings = _warnings.Count + _moreWarnings;
        line += $"; {Count(RowsLeftOut, "row")} left out; {Count(warnings, "warning")}";
        if (warnings > 0)
        {
            // A warning is a sentence, which may have semicolons of its own.
            line += ": " + (warnings == 1 ? _warnings[0] : string.Join(", ", _warnings.Take(MaxListed).Select(static (warning, index) => $"({index + 1}) {warning}")));
            if (warnings > MaxListed)
                line += $", and {warnings - MaxListed} more, which info lists";
        }

        return line + (_losses.Count > 0 ? $"; not kept: {string.Join(", ", _losses)}." : ".");
    }

    private static string Count(long count, string what) =>
        count == 0 ? $"no {what}s" : Quantity.Format($"{count:#,0} {what}{(count == 1 ? string.Empty : "s")}");
}
