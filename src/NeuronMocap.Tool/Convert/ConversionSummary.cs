using NeuronMocap.Bvh;
using NeuronMocap.Calculation;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Convert;

/// <summary>The summary of convert in one line: the contents of the new file, the data that it lacks, and warnings.</summary>
internal sealed class ConversionSummary
{
    private const int MaxListed = 3;

    private readonly List<string> _warnings = [];
    private readonly List<string> _losses = [];
    private long _moreWarnings;

    /// <summary>Number of frames in the new file.</summary>
    public long Frames { get; set; }

    /// <summary>Frames per second; null if the file has its own times, or no times.</summary>
    public double? FrameRate { get; set; }

    /// <summary>Duration in seconds; null if it is unknown.</summary>
    public double? Seconds { get; set; }

    /// <summary>Number of gaps in the new file.</summary>
    public long Gaps { get; set; }

    /// <summary>Number of frames missing in the gaps.</summary>
    public long MissingFrames { get; set; }

    /// <summary>Number of frames that were interpolated to fill gaps.</summary>
    public long InterpolatedFrames { get; set; }

    /// <summary>Number of invalid rows of the old file that are not in the new one.</summary>
    public long RowsLeftOut { get; set; }

    public void AddWarning(string warning) => _warnings.Add(warning.TrimEnd('.'));

    /// <summary>Adds data of the old file that the new one cannot hold.</summary>
    public void AddLoss(string loss) => _losses.Add(loss);

    /// <summary>Adds the defects of a BVH file.</summary>
    public void AddRepairs(BvhDocument document)
    {
        RowsLeftOut += document.SkippedRowCount;
        if (document.InnerSkippedRowCount is > 0 and var inner)
            AddWarning($"{Count(inner, "row")} left out before others, so later frames come earlier than in the take");

        foreach (BvhRepair repair in document.Repairs)
            AddWarning(repair.ToString());

        _moreWarnings += document.RepairCount - document.Repairs.Count;
    }

    /// <summary>Adds the defects of a calculation export, after it was read.</summary>
    public void AddRepairs(IReadOnlyList<CalculationRepair> repairs, int count, int leftOut)
    {
        RowsLeftOut += leftOut;
        foreach (CalculationRepair repair in repairs)
            AddWarning(repair.ToString());

        _moreWarnings += count - repairs.Count;
    }

    /// <summary>Gets the line.</summary>
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
            // A warning is a sentence that may contain semicolons.
            line += ": " + (warnings == 1 ? _warnings[0] : string.Join(", ", _warnings.Take(MaxListed).Select(static (warning, index) => $"({index + 1}) {warning}")));
            if (warnings > MaxListed)
                line += $", and {warnings - MaxListed} more, which info lists";
        }

        return line + (_losses.Count > 0 ? $"; not kept: {string.Join(", ", _losses)}." : ".");
    }

    private static string Count(long count, string what) =>
        count == 0 ? $"no {what}s" : Quantity.Count(count, what);
}
