using NeuronMocap.Protocol;

namespace NeuronMocap.Transport;

// Receives the bytes of one opening of a source. Any thread can close it at any time, once.
internal abstract class ByteReceiver
{
    public abstract ReceiveThread Thread { get; }

    // The exception of the source that ended the bytes; null if they just ended. Set before ReceiveAsync completes.
    public Exception? Failure { get; protected set; }

    // Delivers bytes inside the gate, until they end, the source fails or the gate is closed. Exceptions of the source are never thrown.
    public abstract Task ReceiveAsync(PacketAssembler assembler, ReceiveGate gate);

    // Ends a pending read if the source can do that. May throw whatever the source throws, and may block as long as the source does.
    public abstract void Close();
}
