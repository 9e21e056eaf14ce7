namespace NeuronMocap.Transport;

internal sealed class TcpReceivers(ReceiveThreads threads)
{
    // The shared instance for all connections of the process.
    public static TcpReceivers Shared { get; } = new(ReceiveThreads.Shared);

    public TcpReceiver Take(ReceiveThread wanted = ReceiveThread.Auto) =>
        threads.TryTake(wanted) ? new BlockingTcpReceiver(threads.Return) : new PooledTcpReceiver();
}
