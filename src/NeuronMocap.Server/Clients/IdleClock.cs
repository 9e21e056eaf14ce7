using System.Diagnostics;

namespace NeuronMocap.Server.Clients;

/// <summary>How long a client has asked nothing. Safe to read on any thread.</summary>
internal sealed class IdleClock
{
    private const long Busy = -1;

    private readonly long _timeout;
    private readonly Func<long> _getTimestamp;
    private long _since;
    private volatile bool _hasAsked;

    /// <summary>Starts the clock.</summary>
    /// <param name="timeout">When the client is to go; infinite for never.</param>
    /// <param name="getTimestamp">The time, in ticks of <see cref="Stopwatch"/>.</param>
    public IdleClock(TimeSpan timeout, Func<long> getTimestamp)
    {
        _timeout = timeout == Timeout.InfiniteTimeSpan ? long.MaxValue : (long)(timeout.TotalSeconds * Stopwatch.Frequency);
        _getTimestamp = getTimestamp;
        _since = getTimestamp();
    }

    /// <summary>Whether the client has ever asked anything.</summary>
    public bool HasAsked => _hasAsked;

    /// <summary>Ticks since the last answer, or since the start; null while an answer is made.</summary>
    public long? Elapsed => Interlocked.Read(ref _since) is var since && since == Busy ? null : _getTimestamp() - since;

    /// <summary>A request came.</summary>
    public void Stop()
    {
        _hasAsked = true;
        Interlocked.Exchange(ref _since, Busy);
    }

    /// <summary>It was answered.</summary>
    public void Restart() => Interlocked.Exchange(ref _since, _getTimestamp());

    /// <summary>How long to wait for the next bytes.</summary>
    /// <returns>Milliseconds; 0 for ever, as sockets have it; null when the time is over.</returns>
    public int? GetRest()
    {
        if (_timeout == long.MaxValue)
            return 0;

        long rest = _timeout - (Elapsed ?? 0);
        return rest <= 0 ? null : (int)Math.Ceiling(rest * 1000.0 / Stopwatch.Frequency);
    }
}
