using System.Diagnostics;

namespace NeuronMocap.Server.Clients;

/// <summary>Measures how long a client has sent no request. Any thread may read it.</summary>
internal sealed class IdleClock
{
    private const long Busy = -1;

    private readonly long _timeout;
    private readonly Func<long> _getTimestamp;
    private long _since;
    private volatile bool _hasAsked;

    /// <summary>Starts the clock.</summary>
    /// <param name="timeout">Idle time after which the client is disconnected; infinite for never.</param>
    /// <param name="getTimestamp">Returns the time in ticks of <see cref="Stopwatch"/>.</param>
    public IdleClock(TimeSpan timeout, Func<long> getTimestamp)
    {
        _timeout = timeout == Timeout.InfiniteTimeSpan ? long.MaxValue : (long)(timeout.TotalSeconds * Stopwatch.Frequency);
        _getTimestamp = getTimestamp;
        _since = getTimestamp();
    }

    /// <summary>Whether the client has ever sent a request.</summary>
    public bool HasAsked => _hasAsked;

    /// <summary>Ticks since the last answer, or since the start. Null while an answer is made.</summary>
    public long? Elapsed => Interlocked.Read(ref _since) is var since && since == Busy ? null : _getTimestamp() - since;

    /// <summary>Stops the clock because a request came.</summary>
    public void Stop()
    {
        _hasAsked = true;
        Interlocked.Exchange(ref _since, Busy);
    }

    /// <summary>Restarts the clock because the request was answered.</summary>
    public void Restart() => Interlocked.Exchange(ref _since, _getTimestamp());

    /// <summary>Gets how long to wait for the next bytes.</summary>
    /// <returns>Milliseconds; 0 for no limit, as sockets define it; null when the time is over.</returns>
    public int? GetRest()
    {
        if (_timeout == long.MaxValue)
            return 0;

        long rest = _timeout - (Elapsed ?? 0);
        return rest <= 0 ? null : (int)Math.Ceiling(rest * 1000.0 / Stopwatch.Frequency);
    }
}
