using System.Diagnostics;

namespace NeuronMocap.Recording;

/// <summary>
/// A clock that a program moves, such as the time of a game. A playback that uses it pauses, slows down and speeds up with it. Thread-safe.
/// </summary>
/// <remarks>
/// Set it as <see cref="PlaybackOptions.Clock"/>. After each <see cref="MoveTo"/>, <see cref="RecordingPlayer.WaitUntilDelivered"/> waits for the
/// frames that are due. A reader whose playback uses such a clock never reports silence, because it cannot know when the clock moves.
/// </remarks>
public sealed class ManualClock
{
    private readonly long _origin = Stopwatch.GetTimestamp();
    private long _ticks;

    // Occurs on the thread that moved the clock.
    internal event Action? Moved;

    /// <summary>The time of the clock, zero at first.</summary>
    public TimeSpan Now => TimeSpan.FromTicks(Interlocked.Read(ref _ticks));

    /// <summary>
    /// The time of the clock in ticks of <see cref="Stopwatch"/>: <see cref="AvatarFrame.Timestamp"/> of a frame that is due now. It equals the real
    /// time only when the clock was created. It never exceeds <see cref="long.MaxValue"/>, which a <see cref="Stopwatch"/> of one tick per nanosecond
    /// reaches after 292 years.
    /// </summary>
    public long Timestamp => RecordedTime.Add(_origin, RecordedTime.ToTimestamp(Now));

    /// <summary>Moves the clock forward.</summary>
    /// <param name="time">The new time, up to <see cref="TimeSpan.MaxValue"/>. If it is not later than <see cref="Now"/>, the clock stays where it is.</param>
    public void MoveTo(TimeSpan time)
    {
        long ticks = Interlocked.Read(ref _ticks);
        while (time.Ticks > ticks)
        {
            long before = Interlocked.CompareExchange(ref _ticks, time.Ticks, ticks);
            if (before == ticks)
            {
                Moved?.Invoke();
                return;
            }

            ticks = before;
        }
    }
}
