using NeuronMocap.Json;

namespace NeuronMocap.Tool.Output;

/// <summary>--json: writes every frame on the receive thread.</summary>
/// <remarks>While the output is blocked, nothing is received, and over TCP the server waits. No frame is left out.</remarks>
internal sealed class JsonOutput : WatchOutput
{
    // The summary gets little time: the reader has already waited for a line that was not read.
    private static readonly TimeSpan SummaryTimeout = TimeSpan.FromSeconds(0.5);

    private readonly Lock _lock = new();
    private readonly JsonLines _lines = new();
    private readonly SkeletonChanges _skeletons = new();
    private readonly Stream _output;
    private readonly TaskCompletionSource _broken = new(TaskCreationOptions.RunContinuationsAsynchronously);
    private bool _closed;

    /// <summary>Writes the first line. Times count from here.</summary>
    /// <param name="output">The stream to write to.</param>
    /// <param name="source">The source, as the command line names it.</param>
    public JsonOutput(Stream output, string source)
    {
        _output = output;
        Write(_lines.Start(source));
    }

    public override void OnMotion(MotionFrame frame)
    {
        lock (_lock)
        {
            if (_skeletons.IsNew(frame))
                Write(_lines.Skeleton(frame));

            Write(_lines.Frame(frame));
        }
    }

    public override void OnCalculation(CalculationFrame frame)
    {
        lock (_lock)
            Write(_lines.Calculation(frame));
    }

    public override void OnStudioCalculation(StudioCalculationFrame frame)
    {
        lock (_lock)
            Write(_lines.StudioCalculation(frame));
    }

    public override void OnStatus(ConnectionStatus status)
    {
        lock (_lock)
            Write(_lines.Status(status));
    }

    public override bool OnFileFailed(FileFailure failure)
    {
        lock (_lock)
            Write(_lines.FileFailed(failure));

        return true;
    }

    public override Task RunAsync(CancellationToken cancellationToken) => Task.WhenAny(_broken.Task, Until(cancellationToken));

    public override void Finish(ReaderStatistics statistics)
    {
        if (!_lock.TryEnter(SummaryTimeout))
            return;

        try
        {
            Write(_lines.Summary(statistics));
            _closed = true;
        }
        finally
        {
            _lock.Exit();
        }
    }

    private void Write(ReadOnlySpan<byte> line)
    {
        if (_closed)
            return;

        try
        {
            _output.Write(line);
            _output.Flush();
        }
        catch (IOException exception)
        {
            OnWriteFailed(exception);
            _closed = true;
            _broken.TrySetResult();
        }
    }
}
