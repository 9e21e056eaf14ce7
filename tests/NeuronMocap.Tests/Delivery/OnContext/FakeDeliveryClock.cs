using System.Diagnostics;
using NeuronMocap.Delivery;

namespace NeuronMocap.Tests.Delivery;

/// <summary>A clock that a test sets. The timer elapses when the test moves the clock past it.</summary>
internal sealed class FakeDeliveryClock : DeliveryClock
{
    private long _now = Stopwatch.Frequency;

    public override long Now => Interlocked.Read(ref _now);

    public bool IsDisposed { get; private set; }

    /// <summary>When the timer elapses; null while it is not set.</summary>
    public long? Due { get; private set; }

    public override void Set(long ticks) => Due = Now + ticks;

    public override void Dispose()
    {
        IsDisposed = true;
        Due = null;
    }

    /// <summary>Moves the clock, as when the timer is late.</summary>
    public void AdvanceWithoutTimer(double milliseconds) => Interlocked.Add(ref _now, (long)(milliseconds * Stopwatch.Frequency / 1000));

    /// <summary>Moves the clock. If the timer is due at the new time, it elapses.</summary>
    public void Advance(double milliseconds)
    {
        AdvanceWithoutTimer(milliseconds);
        if (Due is not { } due || due > Now)
            return;

        Due = null;
        Elapsed?.Invoke();
    }
}
