using System.Diagnostics;

namespace NeuronMocap.Delivery;

// The time and a timer. Tests have their own.
internal abstract class DeliveryClock : IDisposable
{
    // Called by the timer, on any thread. It must be set before the timer is.
    public Action? Elapsed { get; set; }

    // In ticks of Stopwatch.
    public abstract long Now { get; }

    // Sets the timer to call Elapsed once, after this many ticks. This replaces an earlier setting.
    public abstract void Set(long ticks);

    public abstract void Dispose();
}

internal sealed class SystemDeliveryClock : DeliveryClock
{
    private readonly Timer _timer;

    public SystemDeliveryClock() =>
        _timer = new Timer(static clock => ((SystemDeliveryClock)clock!).Elapsed?.Invoke(), this, Timeout.Infinite, Timeout.Infinite);

    public override long Now => Stopwatch.GetTimestamp();

    public override void Set(long ticks)
    {
        // Rounded up: an early call would find nothing due. After the longest time that a timer accepts, it does find nothing, and the timer is set again.
        double milliseconds = Math.Min((Math.Max(ticks, 0) * 1000.0 / Stopwatch.Frequency) + 1, int.MaxValue);
        try
        {
            _timer.Change((long)milliseconds, Timeout.Infinite);
        }
        catch (ObjectDisposedException)
        {
            // Closed at the same time on another thread; nothing is due any more.
        }
    }

    public override void Dispose() => _timer.Dispose();
}
