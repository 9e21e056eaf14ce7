namespace NeuronMocap.Transport;

// Every connection has a thread: what this target offers for waiting without one allocates for every wait.
internal sealed class TcpReceivers
{
    public static TcpReceivers Shared { get; } = new();

    public TcpReceiver Take() => new BlockingTcpReceiver();
}
