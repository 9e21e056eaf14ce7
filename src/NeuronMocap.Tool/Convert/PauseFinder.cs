namespace NeuronMocap.Tool.Convert;

/// <summary>A pause of a server.</summary>
/// <param name="Frame">Number of the first frame after the pause, counting from 0 in the order of the calls.</param>
/// <param name="Time">When the server sent that frame.</param>
internal readonly record struct Pause(long Frame, TimeSpan Time);

/// <summary>Finds the pauses of a server that continues its numbers after them, from the frames of one avatar. Not thread-safe.</summary>
/// <remarks>
/// A network that stalls delivers what it held back at once, and later frames are on time again. After a pause, all frames stay late. A network
/// that stalls for longer than <see cref="LongestStall"/> loses the connection. So the frames within this time decide.
/// </remarks>
/// <param name="perSecond">Gets how far the numbers advance in a second; null if that is not known.</param>
internal sealed class PauseFinder(Func<double?> perSecond)
{
    /// <summary>The shortest pause. Shorter ones cannot be distinguished from jitter.</summary>
    public static readonly TimeSpan ShortestPause = TimeSpan.FromSeconds(0.25);

    private static readonly TimeSpan LongestStall = TimeSpan.FromSeconds(10);

    private const int MostArrivals = 20_000;

    // The last arrival. While pauses are suspected, all arrivals from the one before the first of them.
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
        if (_arrivals.Count > 0 && time - _arrivals[^1].Time > ShortestPause && LateBetween(_arrivals[^1], arrival) > ShortestPause)
            _suspected.Enqueue(_removed + _arrivals.Count);

        _arrivals.Add(arrival);
        while (_suspected.TryPeek(out long first) && (time - At(first).Time > LongestStall || _arrivals.Count > MostArrivals))
            Decide();

        if (_suspected.Count == 0)
            Remove(_arrivals.Count - 1);
    }

    /// <summary>Decides about the pauses that are suspected: no frame of the run follows.</summary>
    public void Finish()
    {
        while (_suspected.Count > 0)
            Decide();
    }

    // A frame was sent no later than the frames after it say.
    private void Decide()
    {
        long place = _suspected.Dequeue();
        int index = (int)(place - _removed);
        Arrival before = _arrivals[index - 1], first = _arrivals[index];
        TimeSpan time = first.Time;
        for (int i = index + 1; i < _arrivals.Count; i++)
        {
            TimeSpan sent = first.Time + LateBetween(first, _arrivals[i]);
            time = sent < time ? sent : time;
        }

        bool isLong = LateBetween(before, first) > LongestStall;
        if (isLong || LateBetween(before, first with { Time = time }) > ShortestPause)
            _pauses.Add(new Pause(first.Frame, isLong ? first.Time : time));

        Remove((int)((_suspected.TryPeek(out long next) ? next : _removed + _arrivals.Count) - _removed) - 1);
    }

    private TimeSpan LateBetween(Arrival before, Arrival after) => perSecond() is { } speed and > 0
        ? after.Time - before.Time - FrameTimes.Of(after.Place - before.Place, speed)
        : after.Time - before.Time;

    private Arrival At(long number) => _arrivals[(int)(number - _removed)];

    private void Remove(int count)
    {
        _arrivals.RemoveRange(0, count);
        _removed += count;
    }

    private readonly record struct Arrival(long Frame, long Place, TimeSpan Time);
}
