namespace NeuronMocap.Transport;

// Decides which connections and UDP ports get a thread. A blocking thread reacts fastest, and more than a few servers at once are rare. Past the limit,
// they share the pool threads, so a process with a thousand connections does not have a thousand threads. docs/internals/performance.md has the figures
// for both.
internal sealed class ReceiveThreads(int limit)
{
    private int _taken;

    // The shared instance for all readers of the process.
    public static ReceiveThreads Shared { get; } = new(limit: 16);

    // If it returns true, Return must follow.
    public bool TryTake(ReceiveThread wanted)
    {
        if (wanted == ReceiveThread.Pool)
            return false;
        if (Interlocked.Increment(ref _taken) <= limit || wanted == ReceiveThread.Dedicated)
            return true;

        Return();
        return false;
    }

    public void Return() => Interlocked.Decrement(ref _taken);
}
