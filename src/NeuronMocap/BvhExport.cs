using NeuronMocap.Delivery;
using NeuronMocap.Frames;
using NeuronMocap.Transport;

namespace NeuronMocap;

/// <summary>
/// A reader's frames on their way into BVH files: <see cref="NeuronReader.ExportBvh"/>. A thread of its own writes; the receive thread puts frames into a queue
/// without ever waiting, and where the disk is too slow the frames that do not fit are dropped and counted here. A process that is killed leaves files that open, with
/// all rows but those of the last quarter of a second. All members may be called from any thread.
/// </summary>
public sealed class BvhExport : IDisposable
{
    private const int FramesAtOnce = 256;

    private static readonly TimeSpan StopTimeout = TimeSpan.FromSeconds(10);
    private static readonly TimeSpan PollPeriod = TimeSpan.FromMilliseconds(20);
    private static readonly TimeSpan FlushPeriod = TimeSpan.FromMilliseconds(200);

    private readonly FrameQueue _queue;
    private readonly MotionIntake _intake;
    private readonly BvhExportFiles _files;
    private readonly BvhExportBodies _bodies;
    private readonly Task _readerEnd;
    private readonly ManualResetEventSlim _stop = new();
    private Exception? _failure;

    internal BvhExport(FrameQueue queue, MotionIntake intake, BvhExportFiles files, BvhExportBodies bodies, Task readerEnd)
    {
        _queue = queue;
        _intake = intake;
        _files = files;
        _bodies = bodies;
        _readerEnd = readerEnd;
        Completion = DedicatedThread.RunAsync("NeuronMocap BVH export", Run);
    }

    /// <summary>The files that were begun, in that order, with what was handed to the system of each, at most a quarter of a second ago.</summary>
    public IReadOnlyList<BvhExportFile> Files => _files.Snapshot;

    /// <summary>Number of rows in all files together, repeated ones included.</summary>
    public long FramesWritten => Files.Sum(static file => (long)file.FrameCount);

    /// <summary>Number of frames that were lost because the disk was too slow and the queue full.</summary>
    public long FramesDropped => _queue.Dropped;

    /// <summary>Number of frames that belong to no file: of other avatars, or with other values than those of the 59 bones.</summary>
    public long FramesIgnored => _files.Ignored;

    /// <summary>Why the export ended before it was asked to; null while it goes on, and when it ended as it should.</summary>
    public Exception? Failure => Volatile.Read(ref _failure);

    /// <summary>
    /// Completes when the files are: after <see cref="Dispose"/>, after the reader's end, after <see cref="BvhExportOptions.MaxFrames"/>, or with a
    /// <see cref="Failure"/>. Never faults.
    /// </summary>
    public Task Completion { get; }

    /// <summary>Writes the frames that wait, completes the files and closes them. Returns within 10 s; again: nothing.</summary>
    public void Dispose()
    {
        _intake.Close();
        _stop.Set();
        Completion.Wait(StopTimeout);
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
            _queue.Dispose();
            _bodies.Dispose();
            Exception? unwritten = _files.Close();
            _failure ??= unwritten;
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
            bool isEnding = IsEnding;
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

    private bool IsEnding => _stop.IsSet || _readerEnd.IsCompleted;

    private void WaitForFrames()
    {
        while (_queue.Count == 0 && !IsEnding)
            _stop.Wait(PollPeriod);
    }
}
