using System.Numerics;
using NeuronMocap.Motion;
using NeuronMocap.Skeleton;
using NeuronMocap.Timing;

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
    private const double DefaultRate = 120; // Hz: that of a suit with fewer than 18 sensors (manual section 1.3)

    private readonly List<RecordedTakeRow> _rows = [];
    private readonly List<RecordedGap> _gaps = [];
    private readonly ChannelLayout _layout;
    private readonly RotationOrder _order;
    private readonly FrameTiming _timing = new();

    // Raw bytes have no real times. Their times come from a given rate and would give a wrong rate where frames were lost.
    public RecordedTimeline(IReadOnlyList<RecordedTakeRow> received, ChannelLayout layout, RotationOrder order, double? evenRate)
    {
        _layout = layout;
        _order = order;
        foreach (RecordedTakeRow row in received)
            _timing.Add(row.Index, row.Time, row.Connection);

        MeasuredFrameRate = evenRate is null ? _timing.MeasuredRate : null;
        FrameRate = evenRate ?? _timing.Rate ?? DefaultRate;
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
    private long? StepBetween(RecordedTakeRow before, RecordedTakeRow row) =>
        before.Connection == row.Connection || (before.Index is not null && row.Index is not null) ? _timing.FramesBetween(before.Index, row.Index) : null;

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
                before.Index + (uint)(i * _timing.Step),
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
}
