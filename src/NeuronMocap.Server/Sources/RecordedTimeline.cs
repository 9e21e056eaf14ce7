using System.Numerics;
using NeuronMocap.Bvh;
using NeuronMocap.Motion;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Server.Sources;

/// <summary>Arranges received frames at even times.</summary>
/// <remarks>
/// The frame index of the server gives the number of missing frames. Short gaps are interpolated. Arrival times jitter, so they only determine the
/// average duration of a frame.
/// </remarks>
internal sealed class RecordedTimeline
{
    private const double LongestFilledGap = 1; // s
    // No suit is faster. If the index jumps but no time has passed, no frames are missing, whatever the index says.
    private const double HighestRate = 1000; // Hz
    private const double RateTolerance = 0.01;
    private const double DefaultRate = 120; // Hz: that of a suit with fewer than 18 sensors (manual section 1.3)
    private const int LargestReduction = 60;

    private readonly List<RecordedTakeRow> _rows = [];
    private readonly List<RecordedGap> _gaps = [];
    private readonly ChannelLayout _layout;
    private readonly RotationOrder _order;
    private readonly int _reduction;

    // Raw bytes have no real times. Their times come from a given rate and would give a wrong rate where frames were lost.
    public RecordedTimeline(IReadOnlyList<RecordedTakeRow> received, ChannelLayout layout, RotationOrder order, double? evenRate)
    {
        _layout = layout;
        _order = order;
        _reduction = FindReduction(received);
        FrameRateEstimator? estimate = evenRate is null ? Measure(received) : null;
        MeasuredFrameRate = estimate?.MeasuredFrameRate;
        FrameRate = evenRate ?? estimate?.FrameRate ?? DefaultRate;
        foreach (RecordedTakeRow row in received)
            Add(row);
    }

    public IReadOnlyList<RecordedTakeRow> Rows => _rows;

    public IReadOnlyList<RecordedGap> Gaps => _gaps;

    public long InterpolatedFrames { get; private set; }

    public double FrameRate { get; }

    /// <summary>Frame rate according to the arrival times. Null if there are no usable arrival times.</summary>
    public double? MeasuredFrameRate { get; }

    // Number of frames from one to the next, 1 for neighbours. Null if the index does not give it.
    private long? StepBetween(RecordedTakeRow before, RecordedTakeRow row)
    {
        if (before.Index is not { } first || row.Index is not { } second)
            return before.Connection == row.Connection ? 1 : null;

        int step = (int)(second - first);
        return step > 0 && step % _reduction == 0 ? step / _reduction : null;
    }

    private void Add(RecordedTakeRow row)
    {
        if (_rows.Count > 0 && StepBetween(_rows[^1], row) is var step && step != 1)
        {
            bool isFilled = step is { } frames && frames <= LongestFilledGap * Math.Min(FrameRate, HighestRate);
            if (isFilled)
                Fill(_rows[^1], row, (int)step!);

            _gaps.Add(new RecordedGap(_rows.Count, row.Time, step - 1, isFilled));
        }

        _rows.Add(row);
    }

    private void Fill(RecordedTakeRow before, RecordedTakeRow after, int step)
    {
        for (int i = 1; i < step; i++)
        {
            float part = (float)i / step;
            var row = new RecordedTakeRow(
                Interpolate(before.Values, after.Values, part),
                before.Index + (uint)(i * _reduction),
                before.Time + ((after.Time - before.Time) * part),
                before.Connection)
            {
                Contacts = part < 0.5f ? before.Contacts : after.Contacts,
            };
            _rows.Add(row);
            InterpolatedFrames++;
        }
    }

    private float[] Interpolate(float[] before, float[] after, float part)
    {
        float[] values = new float[before.Length];
        BoneTransform[] from = Read(before);
        BoneTransform[] to = Read(after);
        PoseInterpolation.Linear(from, to, part, from);
        foreach (Bone bone in BoneHierarchy.Bones)
            PoseValues.Write(values, _layout, _order, bone, from[(int)bone]);

        if (_layout.HasReference)
            PoseValues.WriteReference(values, _order, from[BoneHierarchy.BoneCount]);

        return values;
    }

    // The values of the reference come last.
    private BoneTransform[] Read(float[] values)
    {
        BoneTransform[] pose = new BoneTransform[BoneHierarchy.BoneCount + 1];
        Span<Vector3> unused = stackalloc Vector3[BoneHierarchy.BoneCount];
        foreach (Bone bone in BoneHierarchy.Bones)
            pose[(int)bone] = PoseValues.Read(values, _layout, _order, bone, unused);

        pose[^1] = PoseValues.ReadReference(values, _layout, _order);
        return pose;
    }

    // The most common step of the index. A server may send only every second or third frame.
    private static int FindReduction(IReadOnlyList<RecordedTakeRow> rows)
    {
        int[] counts = new int[LargestReduction + 1];
        for (int i = 1; i < rows.Count; i++)
        {
            if (rows[i - 1].Index is { } before && rows[i].Index is { } now && now - before is > 0 and <= LargestReduction and var step)
                counts[(int)step]++;
        }

        int most = counts.Max();
        return most == 0 ? 1 : Array.IndexOf(counts, most);
    }

    // Measures over all stretches for which the index gives the number of frames.
    private FrameRateEstimator Measure(IReadOnlyList<RecordedTakeRow> rows)
    {
        var estimate = new FrameRateEstimator();
        long frame = 0;
        for (int i = 0; i < rows.Count; i++)
        {
            if (i > 0
                && StepBetween(rows[i - 1], rows[i]) is { } step
                && rows[i].Time >= rows[i - 1].Time
                && rows[i - 1].Connection == rows[i].Connection)
            {
                estimate.Add(frame += step, rows[i].Time);
            }
            else
            {
                estimate.Restart(frame, rows[i].Time);
            }
        }

        return estimate;
    }

    public static double ChooseFrameRate(double measured)
    {
        double nearest = BvhFrameTimeText.UsualRates.ToArray().OrderBy(rate => Math.Abs(rate - measured)).First();
        return Math.Abs(nearest - measured) <= nearest * RateTolerance ? nearest : measured;
    }
}
