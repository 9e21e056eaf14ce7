using NeuronMocap.Files;
using NeuronMocap.Protocol;
using NeuronMocap.Transport;
using static System.FormattableString;

namespace NeuronMocap.Recording;

/// <summary>
/// Records the bytes that a reader receives, whether they form packets or not. Created by <see cref="NeuronReader.StartRecording"/>. Thread-safe.
/// </summary>
/// <remarks>
/// <para>
/// The reader never waits for the recording. Its receive thread copies each piece into a queue, and a separate thread writes. If the queue is full,
/// pieces are lost. The recording marks the position, and the statistics count them.
/// </para>
/// <para>
/// If the file cannot be written, for example on a full disk, the recording ends (<see cref="Failure"/>) and the reader continues.
/// </para>
/// </remarks>
public sealed class StreamRecorder : IStreamListener, IFileOutput, IDisposable, IAsyncDisposable
{
    // Maximum wait for a disk that no longer responds.
    private static readonly TimeSpan StopTimeout = TimeSpan.FromSeconds(10);

    private readonly RecordingClock _clock = new();
    private readonly RecordingFiles _files;
    private readonly RecordingThread _thread;
    private readonly StreamTap _tap;
    private readonly Action<StreamRecorder> _ended;
    private readonly TaskCompletionSource<bool> _completion = new(TaskCreationOptions.RunContinuationsAsynchronously);

    private volatile Exception? _failure;
    private long _duration = -1;

    // Null at the end, which frees its memory while the statistics remain available.
    private volatile PieceRing? _ring;

    // Producer: the open connections, two at most, and the numbers of pieces and bytes that were queued or lost.
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
            // There was no memory for the queue, or no thread.
            tap.Remove(this);
            _files.Dispose();
            throw;
        }
    }

    /// <summary>The path as the caller gave it. If the recording has several files, their names have a number before the extension.</summary>
    public string Path { get; }

    /// <summary>The file that is being written, or was written last.</summary>
    public string CurrentPath => _files.CurrentPath;

    /// <summary>Whether the recording runs. False after it was stopped, the reader ended, or it failed.</summary>
    public bool IsRecording => _ring is not null;

    /// <summary>The exception that ended the recording early, for example because the disk is full; otherwise null.</summary>
    public Exception? Failure => _failure;

    /// <summary>Completes when the recording has ended and its file is closed. The task never faults; see <see cref="Failure"/>.</summary>
    public Task Completion => _completion.Task;

    // Like Completion, but continuations run on the recording's thread.
    internal Task Ended { get; }

    Task IFileOutput.Ended => Ended;

    long IFileOutput.Lost => GetStatistics().LostPieces;

    int IFileOutput.UndeletedFiles => _files.Undeleted;

    /// <summary>Gets the statistics of the recording. They remain available after the end.</summary>
    /// <returns>A snapshot.</returns>
    public RecordingStatistics GetStatistics()
    {
        long ended = Volatile.Read(ref _duration);
        (long pieces, long bytes) = (_files.Pieces, _files.PieceBytes);
        (long lostPieces, long lostBytes) = (Volatile.Read(ref _lostPieces), Volatile.Read(ref _lostBytes));
        if (ended >= 0 && _failure is not null)
        {
            // Pieces that were queued when the recording failed are also missing.
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
    /// Ends the recording without blocking. Queued pieces are written, and the file is closed. Further calls have no effect.
    /// </summary>
    /// <param name="cancellationToken">Cancels the wait, but not the end of the recording.</param>
    /// <returns>A task that completes when the file is closed, however long the disk takes. Check <see cref="Failure"/> afterwards.</returns>
    /// <exception cref="OperationCanceledException">The wait was cancelled.</exception>
    public Task StopAsync(CancellationToken cancellationToken = default)
    {
        Stop();
        return TaskWaiting.WaitAsync(Completion, cancellationToken);
    }

    /// <summary>Ends the recording like <see cref="Dispose"/>, without blocking the thread.</summary>
    /// <returns>A task that completes when the file is closed, or after 10 s.</returns>
    public ValueTask DisposeAsync()
    {
        Stop();
        return TaskWaiting.WaitAsync(Completion, StopTimeout);
    }

    /// <summary>
    /// Ends the recording: queued pieces are written, and the file is closed. This blocks for at most 10 s; a slower disk continues in the
    /// background. Further calls have no effect. <see cref="StopAsync"/> and <see cref="DisposeAsync"/> do not block.
    /// </summary>
    public void Dispose()
    {
        Stop();
        _completion.Task.Wait(StopTimeout);
    }

    // Does not wait.
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
        return Invariant($"The recording lost {CountedNoun.Of(count, "piece")} because {Path} could not be written fast enough; {statistics.LostPieces} in total, {CountedNoun.Of(statistics.LostBytes, "byte")}.");
    }

    string IFileOutput.DescribeUndeleted() =>
        $"An old file of the recording could not be deleted ({_files.UndeletedReason}) The recording continues and tries again with the next file.";

    string IFileOutput.DescribeEnd()
    {
        RecordingStatistics statistics = GetStatistics();
        return _failure is { } failure
            ? Invariant($"The recording to {CurrentPath} failed: {failure.Message.TrimEnd('.')}. It holds {CountedNoun.Of(statistics.Bytes, "byte")}; {CountedNoun.Of(statistics.LostPieces, "piece")} could not be written.")
            : Invariant($"Recorded {CountedNoun.Of(statistics.Bytes, "byte")} in {statistics.Duration.TotalSeconds:0.0} s to {CurrentPath}.");
    }

    internal void SetMetadata(string key, string value) => _thread.SetMetadata(key, value);

    void IStreamListener.OnOpened(StreamConnection connection, bool wasOpen, long timestamp)
    {
        bool isReported = _ring is { } ring && RecordedLink.TryReportOpened(ring, connection, wasOpen, timestamp);
        _links = [.. _links.Where(link => link.Connection.IsCalculation != connection.IsCalculation), new RecordedLink(connection, isReported)];
    }

    void IStreamListener.OnBytes(StreamConnection connection, int number, byte[] sender, ArraySegment<byte> bytes, long timestamp)
    {
        if (_ring is not { } ring || Find(connection) is not { } link)
            return;

        var record = new PieceRecord { Kind = PieceKind.Bytes, Connection = connection.Number, Sender = number, Timestamp = timestamp };
        if (bytes.Count <= RecordingWriter.MaxPieceLength && ring.HasRoom(sender.Length + bytes.Count)
            && link.TryReportPending(ring, timestamp) && ring.TryWrite(record, sender, bytes))
        {
            Volatile.Write(ref _takenPieces, _takenPieces + 1);
            Volatile.Write(ref _takenBytes, _takenBytes + bytes.Count);
            return;
        }

        link.Lose(bytes.Count);
        Volatile.Write(ref _lostPieces, _lostPieces + 1);
        Volatile.Write(ref _lostBytes, _lostBytes + bytes.Count);
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

    private void Run()
    {
        try
        {
            using (_files)
                _thread.Run(() => (Volatile.Read(ref _lostPieces), Volatile.Read(ref _lostBytes)));
        }
        catch (Exception exception)
        {
            // The exception must not end the process or the reader.
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
