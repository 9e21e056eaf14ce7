using NeuronMocap.Files;
using NeuronMocap.Protocol;
using NeuronMocap.Transport;
using static System.FormattableString;

namespace NeuronMocap.Bvh;

/// <summary>
/// Writes the frames of a reader to BVH files: <see cref="NeuronReader.ExportBvh"/>. Thread-safe.
/// </summary>
/// <remarks>
/// <para>
/// A separate thread writes. The receive thread adds frames to a queue and never waits. If the disk is too slow, frames that do not fit are dropped
/// and counted here.
/// </para>
/// <para>
/// If the process is killed, the files can be opened and hold all rows except those of the last quarter of a second. A full disk ends the export
/// (<see cref="Failure"/>) but not the reader. The counters here then match the content of the files.
/// </para>
/// </remarks>
public sealed class BvhExport : IFileOutput, IDisposable, IAsyncDisposable
{
    private const int FramesAtOnce = 256;

    private static readonly TimeSpan StopTimeout = TimeSpan.FromSeconds(10);
    private static readonly TimeSpan PollPeriod = TimeSpan.FromMilliseconds(20);
    private static readonly TimeSpan FlushPeriod = TimeSpan.FromMilliseconds(200);

    private readonly FrameQueue _queue;
    private readonly BvhExportFiles _files;
    private readonly BvhExportBodies _bodies;
    private readonly Action<IFileOutput> _ended;
    private readonly ManualResetEventSlim _stop = new();
    private readonly TaskCompletionSource<bool> _completion = new(TaskCreationOptions.RunContinuationsAsynchronously);
    private readonly Task _threadEnd;
    private Exception? _failure;
    private long _lostAtFailure;

    internal BvhExport(string path, FrameQueue queue, BvhExportFiles files, BvhExportBodies bodies, Action<IFileOutput> ended)
    {
        Path = path;
        _queue = queue;
        _files = files;
        _bodies = bodies;
        _ended = ended;
        _threadEnd = DedicatedThread.RunAsync("NeuronMocap BVH export", Run, TaskCreationOptions.None);
    }

    /// <summary>
    /// The path as the caller gave it. If there are several avatars or parts, the file names derive from it: see <see cref="Files"/>.
    /// </summary>
    public string Path { get; }

    /// <summary>
    /// The files in the order of creation. The counters describe the data passed to the operating system, at most a quarter of a second ago.
    /// </summary>
    public IReadOnlyList<BvhExportFile> Files => _files.Snapshot;

    /// <summary>Number of rows in all files, including repeated rows.</summary>
    public long FramesWritten => Files.Sum(static file => (long)file.FrameCount);

    /// <summary>
    /// Number of frames dropped because of the disk. Either the queue was full because the disk was too slow, or writing failed
    /// (<see cref="Failure"/>).
    /// </summary>
    public long FramesDropped => _queue.Dropped + Volatile.Read(ref _lostAtFailure);

    /// <summary>Number of frames that do not belong to any file: frames of other avatars, or frames without the values of the 59 bones.</summary>
    public long FramesIgnored => _files.Ignored;

    /// <summary>The exception that ended the export early; null while it runs and after a normal end.</summary>
    public Exception? Failure => Volatile.Read(ref _failure);

    /// <summary>
    /// Completes when the files are complete: after <see cref="Dispose"/>, after the reader ends, after <see cref="BvhExportOptions.MaxFrames"/>,
    /// or with a <see cref="Failure"/>. The task never faults.
    /// </summary>
    public Task Completion => _completion.Task;

    Task IFileOutput.Ended => _threadEnd;

    long IFileOutput.Lost => FramesDropped;

    int IFileOutput.UndeletedFiles => 0;

    /// <summary>
    /// Ends the export without blocking. Queued frames are written, and the files are completed and closed. Further calls have no effect.
    /// </summary>
    /// <param name="cancellationToken">Cancels the wait, but not the end of the export.</param>
    /// <returns>A task that completes when the files are closed, however long the disk takes. Check <see cref="Failure"/> afterwards.</returns>
    /// <exception cref="OperationCanceledException">The wait was cancelled.</exception>
    public Task StopAsync(CancellationToken cancellationToken = default)
    {
        Stop();
        return TaskWaiting.WaitAsync(Completion, cancellationToken);
    }

    /// <summary>Ends the export like <see cref="Dispose"/>, without blocking the thread.</summary>
    /// <returns>A task that completes when the files are closed, or after 10 s.</returns>
    public ValueTask DisposeAsync()
    {
        Stop();
        return TaskWaiting.WaitAsync(Completion, StopTimeout);
    }

    /// <summary>
    /// Writes the queued frames, and completes and closes the files. This blocks for at most 10 s; a slower disk continues in the background.
    /// Further calls have no effect. <see cref="StopAsync"/> and <see cref="DisposeAsync"/> do not block.
    /// </summary>
    public void Dispose()
    {
        Stop();
        Completion.Wait(StopTimeout);
    }

    void IFileOutput.Stop() => Stop();

    string IFileOutput.DescribeStart() => $"Exporting BVH to {Path}.";

    string IFileOutput.DescribeLoss(long count) =>
        Invariant($"The export to {Path} dropped {CountedNoun.Of(count, "frame")} because the disk is too slow; {FramesDropped} in total.");

    string IFileOutput.DescribeUndeleted() => string.Empty;

    string IFileOutput.DescribeEnd() => Failure is { } failure
        ? Invariant($"The export to {Path} failed: {failure.Message.TrimEnd('.')}. It holds {CountedNoun.Of(FramesWritten, "frame")}; {CountedNoun.Of(FramesDropped, "frame")} could not be written.")
        : Invariant($"Exported {CountedNoun.Of(FramesWritten, "frame")} to {(Files is [var only] ? only.Path : Invariant($"{Files.Count} files, named after {Path}"))}.");

    private void Stop()
    {
        _queue.CompleteAdding();
        _stop.Set();
    }

    private void Run()
    {
        try
        {
            Write();
        }
        catch (Exception exception)
        {
            Volatile.Write(ref _failure, exception);
        }
        finally
        {
            End();
        }
    }

    private void End()
    {
        try
        {
            _queue.CompleteAdding();
            long waiting = _queue.Count;
            _queue.Dispose();
            Exception? unwritten = _files.Close();
            if ((_failure ?? unwritten) is { } failure)
            {
                Volatile.Write(ref _lostAtFailure, waiting + _files.Cut);
                Volatile.Write(ref _failure, failure);
            }
        }
        finally
        {
            _completion.TrySetResult(true);
            _ended(this);
        }
    }

    // The end is checked before the queue. Frames queued before the end are therefore still written.
    private void Write()
    {
        Action<MotionFrame> onMotion = _files.Write;
        WaitForFrames();
        _bodies.WaitForFormat(_stop);
        var sinceFlush = System.Diagnostics.Stopwatch.StartNew();
        while (!_files.IsFull)
        {
            bool isEnding = _stop.IsSet;
            int taken = _queue.Pump(onMotion, maxFrames: FramesAtOnce);
            if (taken == 0 && isEnding)
                return;

            if (sinceFlush.Elapsed >= FlushPeriod)
            {
                _files.Flush();
                sinceFlush.Restart();
            }

            if (taken == 0)
                _stop.Wait(PollPeriod);
        }
    }

    private void WaitForFrames()
    {
        while (_queue.Count == 0 && !_stop.IsSet)
            _stop.Wait(PollPeriod);
    }
}
