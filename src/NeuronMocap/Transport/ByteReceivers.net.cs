using System.IO.Pipelines;
using System.IO.Pipes;
using System.Net.Sockets;

namespace NeuronMocap.Transport;

internal static class ByteReceivers
{
    private const int BufferSize = 64 * 1024;

    private static readonly StreamPipeReaderOptions Options = new(bufferSize: BufferSize, leaveOpen: true);

    // A read of zero bytes waits without a buffer.
    private static readonly StreamPipeReaderOptions WithEmptyReads = new(bufferSize: BufferSize, leaveOpen: true, useZeroByteReads: true);

    public static ByteReceiver Create(Stream stream, bool leaveOpen, ReceiveThread wanted) => wanted == ReceiveThread.Dedicated
        ? new BlockingStreamReceiver(stream, leaveOpen)
        : new PipeReceiver(PipeReader.Create(stream, SupportsEmptyReads(stream) ? WithEmptyReads : Options), leaveOpen ? null : stream);

    // Other streams may never complete such a read: a serial port on Windows, and what wraps one, such as an SslStream.
    private static bool SupportsEmptyReads(Stream stream) => stream is PipeStream || stream.GetType() == typeof(NetworkStream);
}
