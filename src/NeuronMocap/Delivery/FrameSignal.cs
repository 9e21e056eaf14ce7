using System.Diagnostics;
using System.Diagnostics.CodeAnalysis;

namespace NeuronMocap.Delivery;

// Wakes the one consumer that waits for a frame of a queue, on a thread of its own or on the thread pool.
//
// To wake a thread takes the time of many frames. A consumer that empties the queue faster than it fills would be woken for each few frames of a stream that
// comes as fast as it can, such as a recording that is played unpaced. In such a flood, the receive thread therefore signals only once for each part of the
// queue, and the consumer looks again after a millisecond. A flood is more than 330 avatars send at 120 Hz.
[SuppressMessage("Design", "CA1001", Justification = "The receive thread may signal after the end. The semaphore holds no handle, and the event frees its own.")]
internal sealed class FrameSignal(FrameQueue queue, Func<long>? clock = null)
{
    // The receive thread goes on while the consumer wakes. The other half has room for that.
    public const int PartsOfQueue = 2;

    // So many frames a second are a flood. They are counted over so many waits, and during a flood over each.
    private const long FloodRate = 40_000;
    private const int WaitsOfCount = 32;
    private static readonly long Millisecond = Stopwatch.Frequency / 1000;
    private static readonly TimeSpan NextLook = TimeSpan.FromMilliseconds(1);

    private readonly Func<long> _clock = clock ?? Stopwatch.GetTimestamp;
    private readonly SemaphoreSlim _semaphore = new(0);
    private AutoResetEvent? _wake; // Made by the first wait that blocks.
    private int _waiting;
    private volatile bool _isFlooded;

    // Consumer. The receive thread reads the flood, and whether there is a signal, without a fence. A frame that it stores meanwhile may give no signal. For a
    // millisecond after a change, which is longer than any store takes, all waits therefore look again.
    private long _looksUntil = Stopwatch.GetTimestamp() + Millisecond;
    private long _counted;
    private long _delivered;
    private int _waits;

    public bool IsFlooded => _isFlooded;

    // Any thread. A full fence separates the packet, which is stored before, from the look at the announcement.
    public void Set()
    {
        switch ((Waiter)Interlocked.Exchange(ref _waiting, (int)Waiter.None))
        {
            case Waiter.Task:
                _semaphore.Release();
                break;
            case Waiter.Thread:
                _wake!.Set();
                break;
        }
    }

    // May return too early.
    public async Task WaitAsync(CancellationToken cancellationToken)
    {
        TimeSpan limit = ChooseLimit();
        if (Announce(Waiter.Task))
            await _semaphore.WaitAsync(limit, cancellationToken).ConfigureAwait(false);

        Withdraw();
    }

    // May return too early. An event, because the semaphore spins before it blocks, and takes a third more processor time.
    public void Wait(CancellationToken cancellationToken)
    {
        _wake ??= new AutoResetEvent(initialState: false);
        TimeSpan limit = ChooseLimit();
        using (cancellationToken.Register(static signal => ((FrameSignal)signal!).Set(), this))
        {
            if (Announce(Waiter.Thread) && !cancellationToken.IsCancellationRequested)
                _wake.WaitOne(limit);
        }

        Withdraw();
        cancellationToken.ThrowIfCancellationRequested();
    }

    private TimeSpan ChooseLimit()
    {
        long now = Stopwatch.GetTimestamp();
        bool wasFlooded = _isFlooded;
        if (JudgeFlood() || wasFlooded)
            _looksUntil = now + Millisecond;

        return now < _looksUntil ? NextLook : Timeout.InfiniteTimeSpan;
    }

    // Announces the wait, then looks again: what arrived before the announcement gave no signal. Returns whether there is nothing to do yet.
    private bool Announce(Waiter waiter)
    {
        Interlocked.Exchange(ref _waiting, (int)waiter);
        return !queue.HasChanged;
    }

    private void Withdraw() => Interlocked.Exchange(ref _waiting, (int)Waiter.None);

    private bool JudgeFlood()
    {
        if (!_isFlooded && ++_waits < WaitsOfCount)
            return false;

        long now = _clock(), delivered = queue.Delivered;
        _isFlooded = (delivered - _delivered) / (double)FloodRate >= (now - _counted) / (double)Stopwatch.Frequency;
        (_counted, _delivered, _waits) = (now, delivered, 0);
        return _isFlooded;
    }

    private enum Waiter
    {
        None,
        Task,
        Thread,
    }
}
