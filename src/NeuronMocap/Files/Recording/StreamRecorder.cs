using System.Globalization;
using NeuronMocap.Files;
using NeuronMocap.Protocol;
using NeuronMocap.Transport;

namespace NeuronMocap.Recording;

/// <summary>
/// Records what a reader receives, byte by byte as it arrives, packets or not; made by <see cref="NeuronReader.StartRecording"/>. The reader never
/// waits for it: its receive thread copies each piece into a queue, and a thread of the recording writes. Where the queue is full, pieces are missing
/// in the recording, which says so at the place, and are counted. A recording that cannot be written any more, because the disk is full for example,
/// ends (<see cref="Failure"/>); the reader goes on. Any thread.
/// </summary>
public sealed class StreamRecorder : IStreamListener, IFileOutput, IDisposable, IAsyncDisposable
{
    // Longest wait for a disk that takes nothing any more.
    private static readonly TimeSpan StopTimeout = TimeSpan.FromSeconds(10);

    private readonly RecordingClock _clock = new();
    private readonly RecordingFiles _files;
    private readonly RecordingThread _thread;
    private readonly StreamTap _tap;
    private readonly Action<StreamRecorder> _ended;
    private readonly TaskCompletionSource<bool> _completion = new(TaskCreationOptions.RunContinuationsAsynchronously);

    private volatile Exception? _failure;
    private long _duration = -1;

    // Null at the end, so that its memory does not stay for the figures' sake.
    private volatile PieceRing? _ring;

    // Producer's: the connections that stand, two at most, and what went into the ring or found no room there.
    private RecordedLink[] _links = [];
    private long _takenPieces;
    private long _takenBytes;
    private long _lostPieces;
    private long _lostBytes;

    internal StreamRecorder(
        string path,
        RecordingOptions options,
        RecordingMetadata metadata,
        StreamTap tap,
        Action<StreamRecorder> ended,
        Func<string, RecordingOptions, Stream>? open = null)
    {
        Path = path;
        _tap = tap;
        _ended = ended;
        _files = new RecordingFiles(path, options, metadata, _clock.StartTime, open);
        try
        {
            _ring = new PieceRing(options.QueueSize);
            _thread = new RecordingThread(_ring, _files, options.FlushInterval, _clock);
            tap.Add(this, RecordingClock.Now);
            Ended = DedicatedThread.RunAsync("NeuronMocap recording", Run, TaskCreationOptions.None);
        }
        catch
        {
            // No memory for the queue, or no thread.
            tap.Remove(this);
            _files.Dispose();
            throw;
        }
    }

    /// <summary>The file as it was asked for. Where files follow each other, their names have a number before the extension.</summary>
    public string Path { get; }

    /// <summary>The file that is written now, or was last.</summary>
    public string CurrentPath => _files.CurrentPath;

    /// <summary>Whether it records. False when it was stopped, the reader ended, or it failed.</summary>
    public bool IsRecording => _ring is not null;

    /// <summary>Why the recording ended before its time: the disk is full, for example. Null while all is well.</summary>
    public Exception? Failure => _failure;

    /// <summary>Completes when the recording has ended and its file is closed. Never faults; see <see cref="Failure"/>.</summary>
    public Task Completion => _completion.Task;

    // As Completion, but what awaits it goes on on the recording's thread.
    internal Task Ended { get; }

    Task IFileOutput.Ended => Ended;

    long IFileOutput.Lost => GetStatistics().LostPieces;

    int IFileOutput.UndeletedFiles => _files.Undeleted;

    /// <summary>What was recorded so far. Also after the end.</summary>
    /// <returns>A snapshot.</returns>
    public RecordingStatistics GetStatistics()
    {
        long ended = Volatile.Read(ref _duration);
        (long pieces, long bytes) = (_files.Pieces, _files.PieceBytes);
        (long lostPieces, long lostBytes) = (Volatile.Read(ref _lostPieces), Volatile.Read(ref _lostBytes));
        if (ended >= 0 && _failure is not null)
        {
            // What the queue held when the recording failed is missing as well.
            lostPieces += Volatile.Read(ref _takenPieces) - pieces;
            lostBytes += Volatile.Read(ref _takenBytes) - bytes;
        }

        return new RecordingStatistics
        {
            Pieces = pieces,
            Bytes = bytes,
            LostPieces = lostPieces,
            LostBytes = lostBytes,
            Files = _files.Count,
            WrittenBytes = _files.WrittenBytes,
            UndeletedFiles = _files.Undeleted,
            Duration = ended >= 0 && _failure is not null ? _files.WrittenTime : ended >= 0 ? new TimeSpan(ended) : _clock.TimeOf(RecordingClock.Now),
        };
    }

    /// <summary>
    /// Ends the recording without blocking: what the queue holds is written, and the file closed. Any number of times.
    /// </summary>
    /// <param name="cancellationToken">Ends the wait; the recording ends all the same.</param>
    /// <returns>A task that completes when the file is closed, however long the disk takes. See <see cref="Failure"/> then.</returns>
    /// <exception cref="OperationCanceledException">The wait was cancelled.</exception>
    public Task StopAsync(CancellationToken cancellationToken = default)
    {
        Stop();
        return TaskWaiting.WaitAsync(Completion, cancellationToken);
    }

    /// <summary>As <see cref="Dispose"/>, without blocking the thread.</summary>
    /// <returns>A task that completes when the file is closed, or after 10 s.</returns>
    public ValueTask DisposeAsync()
    {
        Stop();
        return TaskWaiting.WaitAsync(Completion, StopTimeout);
    }

    /// <summary>
    /// Ends the recording: what the queue holds is written, and the file closed. Blocks until then, 10 s at most; a disk that takes longer is left
    /// behind. Any number of times. <see cref="StopAsync"/> and <see cref="DisposeAsync"/> do not block.
    /// </summary>
    public void Dispose()
    {
        Stop();
        _completion.Task.Wait(StopTimeout);
    }

    // Without waiting.
    internal void Stop()
    {
        _tap.Remove(this);
        _thread.Stop();
    }

    void IFileOutput.Stop() => Stop();

    string IFileOutput.DescribeStart() => $"Recording to {Path}.";

    string IFileOutput.DescribeLoss(long count)
    {
        RecordingStatistics statistics = GetStatistics();
        return Text($"The recording lacks {Number(count, "piece")} that arrived faster than {Path} could be written; {statistics.LostPieces} in all, {Number(statistics.LostBytes, "byte")}.");
    }

    string IFileOutput.DescribeUndeleted() =>
        $"An old file of the recording could not be deleted ({_files.UndeletedReason}) The next file tries again; the recording goes on.";

    string IFileOutput.DescribeEnd()
    {
        RecordingStatistics statistics = GetStatistics();
        return _failure is { } failure
            ? Text($"The recording to {CurrentPath} failed: {failure.Message.TrimEnd('.')}. It holds {Number(statistics.Bytes, "byte")}; {Number(statistics.LostPieces, "piece")} that arrived are lost.")
            : Text($"Recorded {Number(statistics.Bytes, "byte")} in {statistics.Duration.TotalSeconds:0.0} s to {CurrentPath}.");
    }

    internal void SetMetadata(string key, string value) => _thread.SetMetadata(key, value);

    void IStreamListener.OnOpened(StreamConnection connection, bool wasOpen, long timestamp)
    {
        bool isReported = _ring is { } ring && RecordedLink.TryReportOpened(ring, connection, wasOpen, timestamp);
        _links = [.. _links.Where(link => link.Connection.IsCalculation != connection.IsCalculation), new RecordedLink(connection, isReported)];
    }

    void IStreamListener.OnBytes(StreamConnection connection, int number, byte[] sender, ReadOnlySpan<byte> bytes, long timestamp)
    {
        if (_ring is not { } ring || Find(connection) is not { } link)
            return;

        var record = new PieceRecord { Kind = PieceKind.Bytes, Connection = connection.Number, Sender = number, Timestamp = timestamp };
        if (bytes.Length <= RecordingWriter.MaxPieceLength && ring.HasRoom(sender.Length + bytes.Length)
            && link.TryReportPending(ring, timestamp) && ring.TryWrite(record, sender, bytes))
        {
            Volatile.Write(ref _takenPieces, _takenPieces + 1);
            Volatile.Write(ref _takenBytes, _takenBytes + bytes.Length);
            return;
        }

        link.Lose(bytes.Length);
        Volatile.Write(ref _lostPieces, _lostPieces + 1);
        Volatile.Write(ref _lostBytes, _lostBytes + bytes.Length);
    }

    void IStreamListener.OnClosed(StreamConnection connection, string reason, long timestamp)
    {
        if (_ring is { } ring)
            Find(connection)?.ReportClosed(ring, reason, timestamp);

        _links = [.. _links.Where(link => link.Connection != connection)];
    }

    private RecordedLink? Find(StreamConnection connection)
    {
        foreach (RecordedLink link in _links)
        {
            if (ReferenceEquals(link.Connection, connection))
                return link;
        }

        return null;
    }

    private static string Number(long count, string noun) => count == 1 ? $"1 {noun}" : Text($"{count} {noun}s");

    private static string Text(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);

    private void Run()
    {
        try
        {
            using (_files)
                _thread.Run(() => (Volatile.Read(ref _lostPieces), Volatile.Read(ref _lostBytes)));
        }
        catch (Exception exception)
        {
            // Whatever it is, it may end neither the process nor the reader.
            _failure = exception;
        }
        finally
        {
            _tap.Remove(this);
            Volatile.Write(ref _duration, _clock.TimeOf(RecordingClock.Now).Ticks);
            _ring = null;
            _completion.TrySetResult(true);
            _ended(this);
        }
    }
}
