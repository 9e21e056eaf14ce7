namespace NeuronMocap.Transport;

// Who gets a thread. A blocking thread answers soonest, and more than a few servers at once is rare; past the limit, connections share the
// pool's threads, so that a process with a thousand of them has no thousand threads. docs/internals/performance.md has the figures of both.
internal sealed class TcpReceivers(int maxThreads)
{
    private int _threads;

    // Of all connections of the process.
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
