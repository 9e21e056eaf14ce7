using System.IO.Pipelines;

namespace NeuronMocap.Transport;

internal static class ByteReceivers
{
    // A read of zero bytes waits without a buffer.
    private static readonly StreamPipeReaderOptions Options = new(bufferSize: 64 * 1024, leaveOpen: true, useZeroByteReads: true);

    public static ByteReceiver Create(Stream stream, bool leaveOpen, ReceiveThread wanted) => wanted == ReceiveThread.Dedicated
        ? new BlockingStreamReceiver(stream, leaveOpen)
        : new PipeReceiver(PipeReader.Create(stream, Options), leaveOpen ? null : stream);
}
