namespace NeuronMocap.Transport;

// Decides which connections get a thread. A blocking thread reacts fastest, and more than a few servers at once are rare. Past the limit, connections
// share the pool threads, so a process with a thousand connections does not have a thousand threads. docs/internals/performance.md has the figures for
// both.
internal sealed class TcpReceivers(int maxThreads)
{
    private int _threads;

    // The shared instance for all connections of the process.
    public static TcpReceivers Shared { get; } = new(maxThreads: 16);

    public TcpReceiver Take(ReceiveThread wanted = ReceiveThread.Auto)
    {
        if (wanted == ReceiveThread.Pool)
            return new PooledTcpReceiver();
        if (Interlocked.Increment(ref _threads) <= maxThreads || wanted == ReceiveThread.Dedicated)
            return new BlockingTcpReceiver(() => Interlocked.Decrement(ref _threads));

        Interlocked.Decrement(ref _threads);
        return new PooledTcpReceiver();
    }
}
