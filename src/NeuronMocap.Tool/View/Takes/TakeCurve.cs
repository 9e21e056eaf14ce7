using System.Numerics;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tool.View.Takes;

/// <summary>A quantity of a bone over time, reduced to some hundred points. No peak is lost.</summary>
/// <param name="Times">Times of the points in milliseconds since the start of the take.</param>
/// <param name="Lowest">Lowest value near each time; not a number for a hole.</param>
/// <param name="Highest">Highest value.</param>
internal sealed record TakeCurve(double[] Times, float[] Lowest, float[] Highest)
{
    private const double Microseconds = 1000; // in a millisecond
    private const int BlocksPerRead = 64;
    private const int BlocksPerPoint = 1;

    /// <summary>The units, in the order of <see cref="CurveQuantity"/>.</summary>
    public static IReadOnlyList<string> Units { get; } = ["m", "°", "m/s"];

    /// <summary>Computes a curve.</summary>
    /// <param name="performer">The performer.</param>
    /// <param name="bone">The bone.</param>
    /// <param name="quantity">The quantity.</param>
    /// <param name="from">Start in microseconds.</param>
    /// <param name="to">End in microseconds, at least the start.</param>
    /// <param name="points">Number of points, at least 1. There are fewer if there are fewer frames.</param>
    public static TakeCurve Of(TakePerformer performer, Bone bone, CurveQuantity quantity, long from, long to, int points)
    {
        if (performer.Frames == 0)
            return new TakeCurve([], [], []);

        int first = performer.Times.FindBlock(from);
        int last = performer.Times.FindBlock(to);
        var buckets = new Buckets(from, to, points);
        if (last - first >= (long)BlocksPerPoint * points && last < performer.Summaries.Count + BlocksPerPoint)
            AddBlocks(performer, bone, quantity, first, last, buckets);
        else
            AddFrames(performer, bone, quantity, first, last, buckets);

        return buckets.ToCurve();
    }

    private static void AddBlocks(TakePerformer performer, Bone bone, CurveQuantity quantity, int first, int last, Buckets buckets)
    {
        long[] times = performer.Times.GetBlockTimes();
        var gaps = new Queue<TimeStretch>(performer.Times.GetGaps());
        float[] values = new float[BlocksPerRead * TakePerformer.SummaryValues];
        int place = (((int)bone * FrameMeter.Quantities) + (int)quantity) * 2;
        for (int block = first; block <= last; block += BlocksPerRead)
        {
            int count = performer.ReadSummaries(block, values);
            for (int i = 0; i < count && block + i <= last; i++)
            {
                // The last frame of a block is just before the next block.
                long end = block + i + 1 < times.Length ? times[block + i + 1] - 1 : performer.Times.End;
                int at = (i * TakePerformer.SummaryValues) + place;
                AddBlock(new TimeStretch(times[block + i], end), gaps, values[at], values[at + 1], buckets);
            }
        }
    }

    // Leaves the gaps in the block out.
    private static void AddBlock(TimeStretch block, Queue<TimeStretch> gaps, float lowest, float highest, Buckets buckets)
    {
        long start = block.From;
        while (gaps.TryPeek(out TimeStretch gap) && gap.From <= block.To)
        {
            gaps.Dequeue();
            if (gap.From >= start)
                buckets.Add(start, gap.From, lowest, highest);

            start = Math.Max(start, gap.To);
        }

        if (start <= block.To)
            buckets.Add(start, block.To, lowest, highest);
    }

    private static void AddFrames(TakePerformer performer, Bone bone, CurveQuantity quantity, int first, int last, Buckets buckets)
    {
        const int Margin = 4; // blocks, for the speed at the edges

        long start = Math.Max(0, first - Margin) * (long)TakeTimes.BlockSize;
        long end = Math.Min(performer.Frames, (last + 1L + Margin) * TakeTimes.BlockSize);
        var chain = new BoneChain(performer.Body, bone);
        var meter = new FrameMeter(joints: 1);
        byte[] poses = new byte[TakeTimes.BlockSize * performer.Poses.RecordSize];
        Span<float> values = stackalloc float[FrameMeter.Quantities];
        for (long frame = start; frame < end; frame += TakeTimes.BlockSize)
        {
            int count = performer.Poses.Read(frame, poses);
            for (int i = 0; i < count; i++)
            {
                (long time, Vector3 place, float angle) = chain.Measure(poses.AsSpan(i * performer.Poses.RecordSize, performer.Poses.RecordSize));
                meter.Add(time / 1e6, [place], [angle]);
                Take(meter, atEnd: false, values, quantity, buckets);
            }
        }

        Take(meter, atEnd: true, values, quantity, buckets);
    }

    private static void Take(FrameMeter meter, bool atEnd, Span<float> values, CurveQuantity quantity, Buckets buckets)
    {
        while (meter.TryTake(atEnd, out double seconds, values))
        {
            long time = (long)Math.Round(seconds * 1e6);
            buckets.Add(time, time, values[(int)quantity], values[(int)quantity]);
        }
    }

    // Equal parts of the time.
    private sealed class Buckets(long from, long to, int points)
    {
        private readonly double _width = Math.Max(1, (to - from) / (double)points);
        private readonly float[] _lowest = Filled(points, float.NaN);
        private readonly float[] _highest = Filled(points, float.NaN);
        private readonly long[] _times = new long[points];
        private readonly int[] _counts = new int[points];

        public void Add(long start, long end, float lowest, float highest)
        {
            if (end < from || start > to || !float.IsFinite(lowest) || !float.IsFinite(highest))
                return;

            int last = IndexOf(end);
            for (int i = IndexOf(start); i <= last; i++)
            {
                _lowest[i] = _lowest[i] <= lowest ? _lowest[i] : lowest;
                _highest[i] = _highest[i] >= highest ? _highest[i] : highest;
                _times[i] = start == end ? start : -1;
                _counts[i]++;
            }
        }

        // A point of a single frame has its time. Parts without frames are left out if there are fewer frames than points.
        public TakeCurve ToCurve()
        {
            bool isSparse = _counts.Sum() < 2L * points;
            int[] kept = [.. Enumerable.Range(0, points).Where(i => !isSparse || _counts[i] > 0)];
            return new TakeCurve(
                [.. kept.Select(TimeOf)],
                [.. kept.Select(i => _lowest[i])],
                [.. kept.Select(i => _highest[i])]);
        }

        private static float[] Filled(int count, float value)
        {
            float[] values = new float[count];
            Array.Fill(values, value);
            return values;
        }

        private int IndexOf(long time) => (int)Math.Clamp((time - from) / _width, 0, points - 1);

        private double TimeOf(int i) => (_counts[i] == 1 && _times[i] >= 0 ? _times[i] : from + ((i + 0.5) * _width)) / Microseconds;
    }
}
