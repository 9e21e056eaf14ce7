namespace NeuronMocap.Tool.Convert;

/// <summary>A pause of a server.</summary>
/// <param name="Frame">Number of the first frame after the pause, counting from 0 in the order of the calls.</param>
/// <param name="Length">How long the server sent nothing, beyond the usual time between its frames.</param>
internal readonly record struct Pause(long Frame, TimeSpan Length);

/// <summary>Finds the pauses of a server that continues its numbers after them, from the frames of one avatar. Not thread-safe.</summary>
/// <remarks>
/// A network that stalls delivers what it held back at once, and later frames are on time again. After a pause, all frames stay late. A network
/// that stalls for longer than <see cref="LongestStall"/> loses the connection. So the frames within this time decide.
/// </remarks>
/// <param name="perSecond">Gets how far the numbers advance in a second of the clock that measures arrivals; null if that is not known.</param>
internal sealed class PauseFinder(Func<double?> perSecond)
{
    /// <summary>The shortest pause. Shorter ones cannot be distinguished from jitter.</summary>
    public static readonly TimeSpan ShortestPause = TimeSpan.FromSeconds(0.25);

    private static readonly TimeSpan LongestStall = TimeSpan.FromSeconds(10);

    private const int MostArrivals = 20_000;

    // Some frame of these is on time.
    private const int Before = 64;

    // The last arrivals. While pauses are suspected, all arrivals from those before the first of them.
    private readonly List<Arrival> _arrivals = [];
    private readonly Queue<long> _suspected = new();
    private readonly List<Pause> _pauses = [];
    private long _removed;

    /// <summary>The pauses, once <see cref="Finish"/> was called.</summary>
    public IReadOnlyList<Pause> Pauses => _pauses;

    /// <summary>Begins a run of numbers: with a connection, or when the server restarts its count.</summary>
    public void Start()
    {
        Finish();
        Remove(_arrivals.Count);
    }

    /// <summary>Adds a frame. A frame that came after a later one must not be added.</summary>
    /// <param name="frame">Its number in the order of the calls.</param>
    /// <param name="place">The number that the server gave it. It grows within a run.</param>
    /// <param name="time">Its time of arrival.</param>
    public void Add(long frame, long place, TimeSpan time)
    {
        var arrival = new Arrival(frame, place, time);
        if (_arrivals.Count > 0 && time - _arrivals[^1].Time > ShortestPause && LateBetween(_arrivals[^1], arrival, perSecond()) > ShortestPause)
            _suspected.Enqueue(_removed + _arrivals.Count);

        _arrivals.Add(arrival);
        while (_suspected.TryPeek(out long first) && (time - At(first).Time > LongestStall || _arrivals.Count > MostArrivals))
            Decide();

        if (_suspected.Count == 0 && _arrivals.Count >= 2 * Before)
            Remove(_arrivals.Count - Before);
    }

    /// <summary>Decides about the pauses that are suspected: no frame of the run follows.</summary>
    public void Finish()
    {
        while (_suspected.Count > 0)
            Decide();
    }

    // A frame was sent no later than the other frames on its side of the pause say.
    private void Decide()
    {
        int index = (int)(_suspected.Dequeue() - _removed);
        double? speed = perSecond();
        Arrival before = _arrivals[index - 1], first = _arrivals[index];
        for (int i = 0; i < index && speed is > 0; i++)
            before = LateBetween(before, _arrivals[i], speed) < TimeSpan.Zero ? _arrivals[i] : before;

        TimeSpan arrived = LateBetween(before, first, speed), length = arrived;
        for (int i = index + 1; i < _arrivals.Count && arrived <= LongestStall; i++)
        {
            TimeSpan late = LateBetween(before, _arrivals[i], speed);
            length = late < length ? late : length;
        }

        bool isPause = length > ShortestPause;
        if (isPause)
            _pauses.Add(new Pause(first.Frame, length));

        // Frames before a pause do not say when those after it were sent.
        long next = _suspected.TryPeek(out long other) ? other : _removed + _arrivals.Count;
        Remove(Math.Max((int)(next - _removed) - Before, isPause ? index : 0));
    }

    private static TimeSpan LateBetween(Arrival before, Arrival after, double? speed) => speed is > 0
        ? after.Time - before.Time - FrameTimes.Of(after.Place - before.Place, speed.Value)
        : after.Time - before.Time;

    private Arrival At(long number) => _arrivals[(int)(number - _removed)];

    private void Remove(int count)
    {
        _arrivals.RemoveRange(0, count);
        _removed += count;
    }

    private readonly record struct Arrival(long Frame, long Place, TimeSpan Time);
}
