namespace NeuronMocap.Transport;

internal static class TcpReceivers
{
    // Always a thread: what this target offers for many sockets at once allocates for every wait.
    public static TcpReceiver Take() => new BlockingTcpReceiver();
}
