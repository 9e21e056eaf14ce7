using System.Threading.Channels;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Output;

/// <summary>Writes lines on a thread of its own, so that nobody waits for a program that reads them slowly. Thread-safe.</summary>
internal sealed class LineQueue
{
    // A minute of ten destinations.
    private const int Capacity = 1024;

    private readonly Channel<byte[]> _lines = Channel.CreateBounded<byte[]>(new BoundedChannelOptions(Capacity) { SingleReader = true });
    private readonly Stream _output;
    private readonly Task _writing;

    /// <summary>Starts the thread.</summary>
    /// <param name="output">The stream to write to. The queue does not close it.</param>
    public LineQueue(Stream output)
    {
        _output = output;
        _writing = Task.Factory.StartNew(WriteAll, CancellationToken.None, TaskCreationOptions.LongRunning, TaskScheduler.Default);
    }

    /// <summary>Why the output could not be written. Null if it was written, or if its reader closed it.</summary>
    public IOException? Failure { get; private set; }

    /// <summary>Adds a line. Without room, the line is left out.</summary>
    public void Add(ReadOnlySpan<byte> line) => _lines.Writer.TryWrite(line.ToArray());

    /// <summary>Adds the last line, and waits for a limited time until everything is written.</summary>
    public async Task FinishAsync(byte[] last, TimeSpan timeout)
    {
        using var limit = new CancellationTokenSource(timeout);
        try
        {
            await _lines.Writer.WriteAsync(last, limit.Token);
            _lines.Writer.Complete();
            await _writing.WaitAsync(limit.Token);
        }
        catch (OperationCanceledException)
        {
            // Nobody reads the output. Its thread ends with the program.
        }
    }

    // After a failure, lines are taken without being written.
    private void WriteAll()
    {
        bool isBroken = false;
        while (_lines.Reader.WaitToReadAsync().AsTask().GetAwaiter().GetResult())
        {
            while (_lines.Reader.TryRead(out byte[]? line))
            {
                if (!isBroken)
                    isBroken = !TryWrite(line);
            }
        }
    }

    private bool TryWrite(byte[] line)
    {
        try
        {
            _output.Write(line);
            _output.Flush();
            return true;
        }
        catch (IOException exception)
        {
            if (!StandardStreams.IsBrokenPipe(exception))
                Failure = exception;

            return false;
        }
    }
}
