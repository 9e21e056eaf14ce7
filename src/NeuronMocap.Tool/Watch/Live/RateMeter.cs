using System.Diagnostics;

namespace NeuronMocap.Tool.Watch.Live;

/// <summary>Measures the growth of a counter per second, over about the last two seconds.</summary>
internal sealed class RateMeter
{
    private const double Window = 2;

    private readonly Queue<(long Timestamp, long Value)> _samples = new();

    public double PerSecond { get; private set; }

    public void Add(long timestamp, long value)
    {
        _samples.Enqueue((timestamp, value));
        while (_samples.Count > 2 && Seconds(_samples.Peek().Timestamp, timestamp) > Window)
            _samples.Dequeue();

        (long first, long old) = _samples.Peek();
        double seconds = Seconds(first, timestamp);
        PerSecond = seconds > 0 ? (value - old) / seconds : 0;
    }

    private static double Seconds(long from, long to) => (to - from) / (double)Stopwatch.Frequency;
}
