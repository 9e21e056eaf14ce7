namespace NeuronMocap.Transport;

internal static class TcpReceivers
{
    // Blocking threads answer soonest, and more than a few servers at once is rare; past these, connections share the pool's threads, so that
    // a process with a thousand of them has no thousand threads. docs/performance.md has the figures.
    public const int MaxThreads = 16;

    private static int _threads;

    public static TcpReceiver Take()
    {
        if (Interlocked.Increment(ref _threads) <= MaxThreads)
            return new BlockingTcpReceiver(static () => Interlocked.Decrement(ref _threads));

        Interlocked.Decrement(ref _threads);
        return new PooledTcpReceiver();
    }
}
