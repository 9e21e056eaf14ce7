using System.Buffers;
using System.Diagnostics;
using System.IO.Pipelines;
using System.Runtime.InteropServices;
using NeuronMocap.Protocol;

namespace NeuronMocap.Transport;

// Reads a pipe on the threads of the pipe, usually pool threads. The assembler gets the segments in place. They go back to the pipe after the handlers have
// returned, so a writer waits for a slow handler. stream: what the pipe reads from, if it must be disposed here.
internal sealed class PipeReceiver(PipeReader reader, Stream? stream = null) : ByteReceiver
{
    // Segments can have any size, but recordings limit the size of a piece.
    private const int LargestPiece = 256 * 1024;

    private const int Created = 0;
    private const int Receiving = 1;
    private const int Completed = 2;

    private volatile int _state;
    private volatile bool _isClosed;

    public override ReceiveThread Thread => ReceiveThread.Pool;

    // The first read has a short thread of its own: a stream may block the caller of ReadAsync, or have more bytes whenever it is asked. Such a stream keeps
    // that thread, and the link can still end.
    public override async Task ReceiveAsync(PacketAssembler assembler, ReceiveGate gate)
    {
        Task receiving = Task.CompletedTask;
        await DedicatedThread.RunAsync("NeuronMocap stream receive", () => receiving = LoopAsync(assembler, gate), TaskCreationOptions.None).ConfigureAwait(false);
        await receiving.ConfigureAwait(false);
    }

    public override void Close()
    {
        _isClosed = true;
        if (TryLeave(Created, Completed))
            Complete();
        else if (_state == Receiving)
            reader.CancelPendingRead();

        stream?.Dispose();
    }

    // One method, so there is one state machine for all reads. A pipe must not be completed during a read, so this method completes it.
    private async Task LoopAsync(PacketAssembler assembler, ReceiveGate gate)
    {
        if (!TryLeave(Created, Receiving))
            return;

        try
        {
            ReadResult result;
            do
            {
                result = await reader.ReadAsync().ConfigureAwait(false);
                if (!gate.TryEnter())
                    return;

                Push(result.Buffer, assembler);
                if (!gate.TryLeave())
                    return;

                reader.AdvanceTo(result.Buffer.End);
            }
            while (!result.IsCompleted && !_isClosed);
        }
        catch (Exception exception) when (!gate.IsInside)
        {
            Failure = exception;
        }
        finally
        {
            _state = Completed;
            Complete();
        }
    }

    private bool TryLeave(int state, int next) => Interlocked.CompareExchange(ref _state, next, state) == state;

    private void Complete()
    {
        try
        {
            reader.Complete();
        }
        catch (Exception exception)
        {
            Failure ??= exception;
        }
    }

    private static void Push(in ReadOnlySequence<byte> buffer, PacketAssembler assembler)
    {
        long timestamp = Stopwatch.GetTimestamp();
        foreach (ReadOnlyMemory<byte> segment in buffer)
        {
            for (int offset = 0; offset < segment.Length; offset += LargestPiece)
                Push(segment.Slice(offset, Math.Min(LargestPiece, segment.Length - offset)), assembler, timestamp);
        }
    }

    private static void Push(ReadOnlyMemory<byte> piece, PacketAssembler assembler, long timestamp)
    {
        if (MemoryMarshal.TryGetArray(piece, out ArraySegment<byte> array))
        {
            assembler.Push(array, timestamp);
            return;
        }

        // Memory outside the managed heap, which packets cannot refer to.
        byte[] copy = ArrayPool<byte>.Shared.Rent(piece.Length);
        try
        {
            piece.CopyTo(copy);
            assembler.Push(new ArraySegment<byte>(copy, 0, piece.Length), timestamp);
        }
        finally
        {
            ArrayPool<byte>.Shared.Return(copy);
        }
    }
}
