using System.Diagnostics.CodeAnalysis;

namespace NeuronMocap.Transport;

internal static class ByteReceivers
{
    // Waiting without a thread allocates at every wait on this target framework.
    [SuppressMessage("Style", "IDE0060", Justification = "The parameter is that of the other target.")]
    public static ByteReceiver Create(Stream stream, bool leaveOpen, ReceiveThread wanted) => new BlockingStreamReceiver(stream, leaveOpen);
}
