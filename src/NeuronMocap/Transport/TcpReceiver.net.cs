using System.Buffers;
using System.Diagnostics;
using System.IO.Pipelines;
using System.Net.Sockets;
using System.Runtime.InteropServices;
using NeuronMocap.Protocol;

namespace NeuronMocap.Transport;

// Reads through a pipe, on whichever pool thread the system's completion arrives; no thread belongs to a connection that is quiet.
internal static class TcpReceiver
{
    private const int BufferSize = 64 * 1024;

    // Completes when the server closes; throws when the connection fails or the socket is closed here.
    public static async Task ReceiveAsync(Socket socket, PacketAssembler assembler)
    {
        using var stream = new NetworkStream(socket, ownsSocket: false);
        PipeReader reader = PipeReader.Create(stream, new StreamPipeReaderOptions(bufferSize: BufferSize, minimumReadSize: 4096, leaveOpen: true));
        try
        {
            while (true)
            {
                ReadResult result = await reader.ReadAsync().ConfigureAwait(false);
                Deliver(result.Buffer, assembler);
                reader.AdvanceTo(result.Buffer.End);
                if (result.IsCompleted)
                    return;
            }
        }
        finally
        {
            await reader.CompleteAsync().ConfigureAwait(false);
        }
    }

    private static void Deliver(in ReadOnlySequence<byte> buffer, PacketAssembler assembler)
    {
        long timestamp = Stopwatch.GetTimestamp();
        foreach (ReadOnlyMemory<byte> memory in buffer)
        {
            // The pipe's memory comes from the array pool.
            MemoryMarshal.TryGetArray(memory, out ArraySegment<byte> piece);
            assembler.Push(piece, timestamp);
        }
    }
}
