using System.Diagnostics;

namespace NeuronMocap.Native.Host;

// Which callbacks run, so that none does any more when the process ends and the objects that they use are destroyed.
internal static class CallbackGate
{
    // A callback may wait for the very thread that ends the process.
    private static readonly TimeSpan Patience = TimeSpan.FromSeconds(1);

    private static int _running;
    private static volatile bool _isClosed;

    // Of the running ones those on this thread, which may itself end the process.
    [ThreadStatic]
    private static int _depth;

    // False when there are to be no more callbacks; otherwise Leave has to follow.
    public static bool TryEnter()
    {
        // Counts before it looks, as Close closes before it counts: one of the two sees the other.
        Interlocked.Increment(ref _running);
        if (_isClosed)
        {
            Interlocked.Decrement(ref _running);
            return false;
        }

        _depth++;
        return true;
    }

    public static void Leave()
    {
        _depth--;
        Interlocked.Decrement(ref _running);
    }

    // No callback begins any more. Waits for those that run, by looking: a signal would cost every callback what only the end of the process needs.
    public static void Close()
    {
        _isClosed = true;
        Interlocked.MemoryBarrier();
        var watch = Stopwatch.StartNew();
        while (Volatile.Read(ref _running) > _depth && watch.Elapsed < Patience)
            Thread.Sleep(1);
    }
}
