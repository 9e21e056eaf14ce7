using System.Diagnostics;
using NeuronMocap.Recording;

namespace NeuronMocap.Tests.Playback;

/// <summary>A clock that each wait advances, so that everything is due at once.</summary>
internal sealed class FakeTime : PlaybackTime
{
    public const long Start = 1_000_000_000_000;

    private long _now = Start;

    public override long Now => Volatile.Read(ref _now);

    /// <summary>The requested waits, in milliseconds since the start.</summary>
    public List<double> Waits { get; } = [];

    /// <summary>Called during each wait, while the player's lock is held.</summary>
    public Action<double>? Waiting { get; set; }

    public static double MillisecondsOf(long instant) => (instant - Start) * 1000.0 / Stopwatch.Frequency;

    public override void Wait(object gate, long instant)
    {
        Waits.Add(MillisecondsOf(instant));
        Waiting?.Invoke(MillisecondsOf(instant));
        Volatile.Write(ref _now, instant);
    }
}
