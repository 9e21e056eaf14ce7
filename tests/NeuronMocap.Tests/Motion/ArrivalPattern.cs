namespace NeuronMocap.Tests.Motion;

/// <summary>
/// Arrival times of 861 frames of a real stream: intervals in whole milliseconds with the mean, deviation and percentiles of shared/data/README.md.
/// The sender's clock is even, so a long interval follows when frames came too early.
/// </summary>
internal static class ArrivalPattern
{
    public const int FrameCount = 861;

    /// <summary>Time between frames on the sender's clock, in seconds.</summary>
    public const double Interval = 8.970 / (FrameCount - 1);

    // Counts of intervals from 7 to 14 ms. There are also two gaps of 22 and 21 ms, each followed immediately by a frame.
    private static readonly int[] Counts = [8, 20, 181, 273, 194, 130, 42, 8];

    public static double[] Create(int seed = 1)
    {
        int[] left = [.. Counts];
        var random = new Random(seed);
        double[] arrivals = new double[FrameCount];
        int sum = 0;
        int gap = 22;
        for (int i = 1; i < FrameCount; i++)
        {
            int interval;
            if (i is 300 or 650)
                interval = gap--;
            else if (i is 301 or 651)
                interval = 0;
            else
                interval = Draw(left, (Interval * 1000 * i) - sum, random);

            sum += interval;
            arrivals[i] = sum / 1000.0;
        }

        return arrivals;
    }

    // Draws the remaining interval closest to the one that is due, with noise.
    private static int Draw(int[] left, double due, Random random)
    {
        double wanted = due + ((random.NextDouble() + random.NextDouble() + random.NextDouble() - 1.5) * 2.7);
        int best = Enumerable.Range(7, left.Length).Where(interval => left[interval - 7] > 0).MinBy(interval => Math.Abs(interval - wanted));
        left[best - 7]--;
        return best;
    }
}
