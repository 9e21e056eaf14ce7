using System.Diagnostics;
using NeuronMocap.Protocol;

namespace NeuronMocap.Transport;

// Reads on its own thread. Most streams end a blocked read when they are disposed. If one does not, its thread waits on without delivering anything.
internal sealed class BlockingStreamReceiver(Stream stream, bool leaveOpen) : ByteReceiver
{
    // As for sockets: small at first, larger for a source that has much at once.
    private const int SmallestBuffer = 16 * 1024;
    private const int LargestBuffer = 256 * 1024;

    public override ReceiveThread Thread => ReceiveThread.Dedicated;

    public override Task ReceiveAsync(PacketAssembler assembler, ReceiveGate gate) =>
        DedicatedThread.RunAsync("NeuronMocap stream receive", () => Receive(assembler, gate), TaskCreationOptions.None);

    public override void Close()
    {
        if (!leaveOpen)
            stream.Dispose();
    }

    private void Receive(PacketAssembler assembler, ReceiveGate gate)
    {
        byte[] buffer = new byte[SmallestBuffer];
        while (Read(buffer) is > 0 and var count && gate.TryEnter())
        {
            assembler.Push(new ArraySegment<byte>(buffer, 0, count), Stopwatch.GetTimestamp());
            if (!gate.TryLeave())
                return;
            if (count == buffer.Length && count < LargestBuffer)
                buffer = new byte[2 * count];
        }
    }

    private int Read(byte[] buffer)
    {
        try
        {
            return stream.Read(buffer, 0, buffer.Length);
        }
        catch (Exception exception)
        {
            Failure = exception;
            return 0;
        }
    }
}
