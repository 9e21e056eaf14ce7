using System.Text;
using NeuronMocap.Protocol;
using NeuronMocap.Transport;

namespace NeuronMocap.Recording;

/// <summary>
/// Records what a reader receives, byte by byte as it arrives, packets or not; made by <see cref="NeuronReader.StartRecording"/>. The reader never
/// waits for it: its receive thread copies each piece into a queue, and a thread of the recording writes. Where the queue is full, pieces are missing
/// in the recording, which says so at the place, and are counted. A recording that cannot be written any more, because the disk is full for example,
/// ends (<see cref="Failure"/>); the reader goes on. Any thread.
/// </summary>
public sealed class StreamRecorder : IStreamListener, IDisposable
{
    // Longest wait for a disk that takes nothing any more.
    private static readonly TimeSpan StopTimeout = TimeSpan.FromSeconds(10);

    private readonly RecordingClock _clock = new();
    private readonly RecordingFiles _files;
    private readonly RecordingThread _thread;
    private readonly StreamTap _tap;
    private readonly Action<StreamRecorder> _ended;
    private readonly TaskCompletionSource<bool> _completion = new(TaskCreationOptions.RunContinuationsAsynchronously);

    // Null at the end, so that its memory does not stay for the figures' sake.
    private volatile PieceRing? _ring;
    private volatile Exception? _failure;
    private long _duration = -1;

    // Producer's.
    private StreamConnection? _connection;
    private bool _isTold;
    private long _untoldPieces;
    private long _untoldBytes;
    private long _pieces;
    private long _bytes;
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
        _ring = new PieceRing(options.QueueSize);
        _thread = new RecordingThread(_ring, _files, options.FlushInterval, _clock);
        tap.Add(this, RecordingClock.Now);
        Ended = DedicatedThread.RunAsync("NeuronMocap recording", Run, TaskCreationOptions.None);
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

    /// <summary>What was recorded so far. Also after the end.</summary>
    /// <returns>A snapshot.</returns>
    public RecordingStatistics GetStatistics()
    {
        long ended = Volatile.Read(ref _duration);
        return new RecordingStatistics
        {
            Pieces = Volatile.Read(ref _pieces),
            Bytes = Volatile.Read(ref _bytes),
            LostPieces = Volatile.Read(ref _lostPieces),
            LostBytes = Volatile.Read(ref _lostBytes),
            Files = _files.Count,
            WrittenBytes = _files.WrittenBytes,
            Duration = ended >= 0 ? new TimeSpan(ended) : _clock.TimeOf(RecordingClock.Now),
        };
    }

    /// <summary>
    /// Ends the recording: what the queue holds is written, and the file closed. Waits for it, 10 s at most; a disk that takes longer is left behind.
    /// Any number of times.
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

    internal void SetMetadata(string key, string value) => _thread.SetMetadata(key, value);

    void IStreamListener.OnOpened(StreamConnection connection, bool wasOpen, long timestamp)
    {
        _connection = connection;
        _isTold = _ring is { } ring && TryTellOpened(ring, connection, wasOpen, timestamp);
    }

    void IStreamListener.OnBytes(int source, byte[] sender, ReadOnlySpan<byte> bytes, long timestamp)
    {
        if (_ring is not { } ring || _connection is not { } connection)
            return;

        var record = new PieceRecord { Kind = PieceKind.Bytes, Connection = connection.Number, Source = source, Timestamp = timestamp };
        if (bytes.Length <= RecordingWriter.MaxPieceLength && ring.HasRoom(sender.Length + bytes.Length)
            && TryTellWhatIsUntold(ring, connection, timestamp) && ring.TryWrite(record, sender, bytes))
        {
            Volatile.Write(ref _pieces, _pieces + 1);
            Volatile.Write(ref _bytes, _bytes + bytes.Length);
            return;
        }

        _untoldPieces++;
        _untoldBytes += bytes.Length;
        Volatile.Write(ref _lostPieces, _lostPieces + 1);
        Volatile.Write(ref _lostBytes, _lostBytes + bytes.Length);
    }

    void IStreamListener.OnClosed(string reason, long timestamp)
    {
        if (_ring is { } ring && _connection is { } connection && _isTold)
        {
            // Both have room kept for them. Where even that is full, the next connection's opening says that this one is gone.
            _ = TryTellLoss(ring, timestamp);
            var record = new PieceRecord { Kind = PieceKind.Closed, Connection = connection.Number, Timestamp = timestamp };
            _ = ring.TryWrite(record, Encoding.UTF8.GetBytes(reason), []);
        }

        _connection = null;
    }

    private static bool TryTellOpened(PieceRing ring, StreamConnection connection, bool wasOpen, long timestamp)
    {
        var record = new PieceRecord
        {
            Kind = PieceKind.Opened,
            Connection = connection.Number,
            IsDatagrams = connection.IsDatagrams,
            WasOpen = wasOpen,
            Timestamp = timestamp,
        };
        return ring.TryWrite(record, Encoding.UTF8.GetBytes($"{connection.Local}\n{connection.Remote}"), []);
    }

    // Before a piece: that its connection opened, if there was no room for it then, and what was lost.
    private bool TryTellWhatIsUntold(PieceRing ring, StreamConnection connection, long timestamp)
    {
        if (!_isTold)
            _isTold = TryTellOpened(ring, connection, wasOpen: true, timestamp);

        return _isTold && TryTellLoss(ring, timestamp);
    }

    private bool TryTellLoss(PieceRing ring, long timestamp)
    {
        if (_untoldPieces == 0)
            return true;

        var record = new PieceRecord
        {
            Kind = PieceKind.Lost,
            Connection = _connection!.Number,
            LostPieces = _untoldPieces,
            LostBytes = _untoldBytes,
            Timestamp = timestamp,
        };
        if (!ring.TryWrite(record, [], []))
            return false;

        _untoldPieces = 0;
        _untoldBytes = 0;
        return true;
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
            // Whatever it is, it may end neither the process nor the reader.
            _failure = exception;
        }
        finally
        {
            _tap.Remove(this);
            Volatile.Write(ref _duration, _clock.TimeOf(RecordingClock.Now).Ticks);
            _ring = null;
            _ended(this);
            _completion.TrySetResult(true);
        }
    }
}
