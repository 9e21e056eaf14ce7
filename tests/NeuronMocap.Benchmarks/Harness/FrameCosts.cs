namespace NeuronMocap.Benchmarks.Harness;

// The processor time of this process from frame to frame. A run has a few much dearer frames, such as those during which the runtime compiles. They move the
// mean, not the median.
internal sealed class FrameCosts
{
    private readonly List<double> _costs = [];
    private TimeSpan? _last;

    // In microseconds. At least two frames must be counted.
    public double Median => Spread.Percentile([.. _costs.Order()], 0.5);

    // Call it once for each frame, on one thread.
    public void Count()
    {
        TimeSpan now = RuntimeFigures.CpuTime;
        if (_last is { } last)
            _costs.Add((now - last).TotalMicroseconds);

        _last = now;
    }
}
