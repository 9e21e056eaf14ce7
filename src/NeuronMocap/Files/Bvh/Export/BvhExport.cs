using System.Globalization;
using NeuronMocap.Delivery;
using NeuronMocap.Files;
using NeuronMocap.Transport;

namespace NeuronMocap.Bvh;

/// <summary>
/// A reader's frames on their way into BVH files: <see cref="NeuronReader.ExportBvh"/>. A thread of its own writes; the receive thread puts frames into a queue
/// without ever waiting, and where the disk is too slow the frames that do not fit are dropped and counted here. A process that is killed leaves files that open, with
/// all rows but those of the last quarter of a second. A full disk ends the export (<see cref="Failure"/>), not the reader, and the files hold what is told here.
/// All members may be called from any thread.
/// </summary>
public sealed class BvhExport : IFileOutput, IDisposable, IAsyncDisposable
{
    private const int FramesAtOnce = 256;

    private static readonly TimeSpan StopTimeout = TimeSpan.FromSeconds(10);
    private static readonly TimeSpan PollPeriod = TimeSpan.FromMilliseconds(20);
    private static readonly TimeSpan FlushPeriod = TimeSpan.FromMilliseconds(200);

    private readonly FrameQueue _queue;
    private readonly MotionOnlyConsumer _intake;
    private readonly BvhExportFiles _files;
    private readonly BvhExportBodies _bodies;
    private readonly Action<IFileOutput> _ended;
    private readonly ManualResetEventSlim _stop = new();
    private readonly TaskCompletionSource<bool> _completion = new(TaskCreationOptions.RunContinuationsAsynchronously);
    private readonly Task _threadEnd;
    private Exception? _failure;
    private long _lostAtFailure;

    internal BvhExport(string path, FrameQueue queue, MotionOnlyConsumer intake, BvhExportFiles files, BvhExportBodies bodies, Action<IFileOutput> ended)
    {
        Path = path;
        _queue = queue;
        _intake = intake;
        _files = files;
        _bodies = bodies;
        _ended = ended;
        _threadEnd = DedicatedThread.RunAsync("NeuronMocap BVH export", Run, TaskCreationOptions.None);
    }

    /// <summary>The file as it was asked for. Where there is one for each avatar, or several parts, what their names are made of: see <see cref="Files"/>.</summary>
    public string Path { get; }

    /// <summary>The files that were begun, in that order, with what was handed to the system of each, at most a quarter of a second ago.</summary>
    public IReadOnlyList<BvhExportFile> Files => _files.Snapshot;

    /// <summary>Number of rows in all files together, repeated ones included.</summary>
    public long FramesWritten => Files.Sum(static file => (long)file.FrameCount);

    /// <summary>
    /// Number of frames that are missing because of the disk: it was too slow and the queue full, or it took no more before they were written
    /// (<see cref="Failure"/>).
    /// </summary>
    public long FramesDropped => _queue.Dropped + Volatile.Read(ref _lostAtFailure);

    /// <summary>Number of frames that belong to no file: of other avatars, or with other values than those of the 59 bones.</summary>
    public long FramesIgnored => _files.Ignored;

    /// <summary>Why the export ended before it was asked to; null while it goes on, and when it ended as it should.</summary>
    public Exception? Failure => Volatile.Read(ref _failure);

    /// <summary>
    /// Completes when the files are: after <see cref="Dispose"/>, after the reader's end, after <see cref="BvhExportOptions.MaxFrames"/>, or with a
    /// <see cref="Failure"/>. Never faults.
    /// </summary>
    public Task Completion => _completion.Task;

    Task IFileOutput.Ended => _threadEnd;

    long IFileOutput.Lost => FramesDropped;

    int IFileOutput.UndeletedFiles => 0;

    /// <summary>Ends the export without blocking: the frames that wait are written, and the files completed and closed. Any number of times.</summary>
    /// <param name="cancellationToken">Ends the wait; the export ends all the same.</param>
    /// <returns>A task that completes when the files are closed, however long the disk takes. See <see cref="Failure"/> then.</returns>
    /// <exception cref="OperationCanceledException">The wait was cancelled.</exception>
    public Task StopAsync(CancellationToken cancellationToken = default)
    {
        Stop();
        return TaskWaiting.WaitAsync(Completion, cancellationToken);
    }

    /// <summary>As <see cref="Dispose"/>, without blocking the thread.</summary>
    /// <returns>A task that completes when the files are closed, or after 10 s.</returns>
    public ValueTask DisposeAsync()
    {
        Stop();
        return TaskWaiting.WaitAsync(Completion, StopTimeout);
    }

    /// <summary>
    /// Writes the frames that wait, completes the files and closes them. Blocks until then, 10 s at most; a disk that takes longer is left behind. Again:
    /// nothing. <see cref="StopAsync"/> and <see cref="DisposeAsync"/> do not block.
    /// </summary>
    public void Dispose()
    {
        Stop();
        Completion.Wait(StopTimeout);
    }

    void IFileOutput.Stop() => Stop();

    string IFileOutput.DescribeStart() => $"Exporting BVH to {Path}.";

    string IFileOutput.DescribeLoss(long count) =>
        Text($"The export to {Path} lacks {Number(count, "frame")} that arrived faster than the disk took them; {FramesDropped} in all.");

    string IFileOutput.DescribeUndeleted() => string.Empty;

    string IFileOutput.DescribeEnd() => Failure is { } failure
        ? Text($"The export to {Path} failed: {failure.Message.TrimEnd('.')}. It holds {Number(FramesWritten, "frame")}; {Number(FramesDropped, "frame")} that arrived are lost.")
        : Text($"Exported {Number(FramesWritten, "frame")} to {(Files is [var only] ? only.Path : Text($"{Files.Count} files, named after {Path}"))}.");

    private void Stop()
    {
        _intake.Close();
        _stop.Set();
    }

    private static string Number(long count, string noun) => count == 1 ? $"1 {noun}" : Text($"{count} {noun}s");

    private static string Text(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);

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
            _intake.Close();
            long waiting = _queue.Count;
            _queue.Dispose();
            Exception? unwritten = _files.Close();
            if ((_failure ?? unwritten) is { } failure)
            {
                Volatile.Write(ref _lostAtFailure, waiting + _files.Cut);
                Volatile.Write(ref _failure, failure);
            }

            _bodies.Dispose();
        }
        finally
        {
            _completion.TrySetResult(true);
            _ended(this);
        }
    }

    // The end is looked at before the queue: what came before the end is still written.
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
