using System.Diagnostics.CodeAnalysis;

namespace NeuronMocap.Transport;

// Every connection has a thread, because waiting without a thread allocates at every wait on this target framework.
internal sealed class TcpReceivers
{
    public static TcpReceivers Shared { get; } = new();

    [SuppressMessage("Performance", "CA1822", Justification = "The member is that of the other target.")]
    public TcpReceiver Take(ReceiveThread wanted = ReceiveThread.Auto) => new BlockingTcpReceiver();
}
