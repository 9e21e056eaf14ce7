namespace NeuronMocap.Benchmarks.Harness;

// The processor time of this process from frame to frame, in microseconds, after a number of frames that do not count: the start of both sides.
internal sealed class FrameCosts(int skipped)
{
    private readonly List<double> _costs = [];
    private int _skipped = skipped;
    private double? _last;

    // At least one frame must count.
    public double Mean => _costs.Average();

    // It leaves the dearer half of the frames out.
    public double Median => Spread.Percentile([.. _costs.Order()], 0.5);

    // Call it once for each frame, on one thread.
    public void Count()
    {
        if (_skipped > 0)
        {
            _skipped--;
            return;
        }

        double now = CpuClock.OfProcess / 1000;
        if (_last is { } last)
            _costs.Add(now - last);

        _last = now;
    }
}
