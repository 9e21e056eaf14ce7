using NeuronMocap.Files;

namespace NeuronMocap.Recording;

/// <summary>
/// Writes a recording (docs/reference/recording.md). Not thread-safe.
/// </summary>
/// <remarks>
/// <para>
/// Entries are collected in blocks. A block is written with one call when it has grown to 64 KB, or when <see cref="Flush"/> is called. Written
/// data never changes.
/// </para>
/// <para>
/// Times must not decrease: an earlier time counts as the time of the previous entry. Exceptions of the stream reach the caller. After such an
/// exception, the writer writes nothing more, and the file ends after the last whole block.
/// </para>
/// </remarks>
public sealed class RecordingWriter : IDisposable
{
    /// <summary>Maximum number of bytes in one piece.</summary>
    public const int MaxPieceLength = RecordingLayout.MaxPiece;

    // A checkpoint follows every MiB, and every change of the metadata. All checkpoints together are limited to a thousandth of the file plus
    // CheckpointAllowance.
    private const long CheckpointDistance = 1024 * 1024;
    private const long CheckpointAllowance = 16 * 1024;
    private const int CheckpointShare = 1000;

    // Size of the data after the last entry, without the index itself: index header, end block, block headers, and the head of a piece.
    private const int ClosingBytes = 4096;
    private const int IndexPlaceBytes = 18;

    private readonly RecordingHeader _header;
    private readonly BlockWriter _blocks;
    private readonly RecordingState _state;
    private readonly RecordingIndex _index = new();
    private readonly EntryEncoder _entries = new();
    private readonly EntryEncoder _checkpoint = new();
    private RecordingTotals _totals;
    private RecordingTotals _writtenTotals;
    private long _writtenTime;
    private long _time;
    private long _lastCheckpoint;
    private long _checkpointBytes;
    private long _checkpointLength;
    private bool _isStateNew;
    private bool _isDisposed;

    /// <summary>Begins a recording on a stream.</summary>
    /// <param name="stream">The stream to write, from its current position, which must be the beginning of the file.</param>
    /// <param name="metadata">The metadata that is already known; null for none.</param>
    /// <param name="options">The options; null for the defaults.</param>
    /// <exception cref="ArgumentException">The stream is not writable.</exception>
    public RecordingWriter(Stream stream, RecordingMetadata? metadata = null, RecordingWriterOptions? options = null)
        : this(stream, new RecordingState(metadata ?? RecordingMetadata.Empty), options ?? new RecordingWriterOptions())
    {
    }

    private RecordingWriter(Stream stream, RecordingState state, RecordingWriterOptions options)
    {
        ArgumentNullException.ThrowIfNull(stream);
        if (!stream.CanWrite)
            throw new ArgumentException("The stream is not writable.", nameof(stream));

        _state = state;
        _header = new RecordingHeader(
            (options.StartTime ?? DateTimeOffset.UtcNow).ToUniversalTime(),
            options.RecordingId == Guid.Empty ? Guid.NewGuid() : options.RecordingId,
            options.FileNumber);
        _blocks = new BlockWriter(stream, _header, options.Compress, options.LeaveOpen);
        WriteCheckpoint();
    }

    /// <summary>The start of the recording, in UTC. All times are relative to it.</summary>
    public DateTimeOffset StartTime => _header.StartTime;

    /// <summary>Identifies the recording. All of its files have the same value.</summary>
    public Guid RecordingId => _header.RecordingId;

    /// <summary>Number of this file within the recording, from 1.</summary>
    public int FileNumber => _header.FileNumber;

    /// <summary>Time of the last entry.</summary>
    public TimeSpan Duration => new(_time);

    /// <summary>Number of bytes of the file so far, including bytes that are not yet written.</summary>
    public long Length => WrittenLength + (_entries.IsEmpty ? 0 : _entries.Block.Length);

    // An upper bound of the file's length if it is closed after one more piece.
    internal long LengthWith(int piece) =>
        Length + piece + ClosingBytes + (2 * _checkpointLength) + (IndexPlaceBytes * (long)(_index.Count + 1));

    /// <summary>Number of bytes that the stream has accepted, in whole blocks.</summary>
    public long WrittenLength => _blocks.Length;

    /// <summary>The totals of the file so far.</summary>
    public RecordingTotals Totals => _totals;

    // The totals of the blocks that the stream has accepted.
    internal RecordingTotals WrittenTotals => _writtenTotals;

    // Time of the last entry in those blocks.
    internal TimeSpan WrittenDuration => new(_writtenTime);

    /// <summary>The metadata of the recording so far.</summary>
    public RecordingMetadata Metadata => _state.Metadata;

    /// <summary>Begins a recording in a new file.</summary>
    /// <param name="path">The path of the file; the usual extension is ".nmrec".</param>
    /// <param name="metadata">The metadata that is already known; null for none.</param>
    /// <param name="options">The options; null for the defaults.</param>
    /// <returns>The writer, which closes the file when disposed.</returns>
    /// <exception cref="IOException">The file already exists, or cannot be created or written.</exception>
    /// <exception cref="UnauthorizedAccessException">The user does not have permission to create the file.</exception>
    public static RecordingWriter Create(string path, RecordingMetadata? metadata = null, RecordingWriterOptions? options = null)
    {
        FileStream stream = WritableFile.CreateNew(path);
        try
        {
            return new RecordingWriter(stream, metadata, options);
        }
        catch
        {
            stream.Dispose();
            throw;
        }
    }

    /// <summary>
    /// Begins the next file of the same recording. The file can be read independently: it starts with the metadata and the open connections and
    /// senders. This writer does not change. The new writer's times are relative to its own start.
    /// </summary>
    /// <param name="stream">The next file.</param>
    /// <param name="time">The start of the next file, in this writer's time.</param>
    /// <returns>The writer of the next file.</returns>
    /// <exception cref="ArgumentException">The stream is not writable.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The next file would start before the year 1 or after the year 9999.</exception>
    public RecordingWriter ContinueIn(Stream stream, TimeSpan time)
    {
        if (time < DateTimeOffset.MinValue - StartTime || time > DateTimeOffset.MaxValue - StartTime)
            throw new ArgumentOutOfRangeException(nameof(time), time, "The next file must start between the years 1 and 9999.");

        var options = new RecordingWriterOptions
        {
            StartTime = StartTime + time,
            Compress = _blocks.Compress,
            LeaveOpen = _blocks.LeaveOpen,
            RecordingId = RecordingId,
            FileNumber = FileNumber + 1,
        };
        return new RecordingWriter(stream, _state.Copy(), options);
    }

    /// <summary>Records that a connection was opened.</summary>
    /// <param name="time">The time since <see cref="StartTime"/>.</param>
    /// <param name="connection">The connection. Its end points are truncated to 255 bytes.</param>
    /// <exception cref="ArgumentOutOfRangeException">The number is negative, or the transport is not defined.</exception>
    /// <exception cref="InvalidOperationException">A connection with that number is open, or 1024 connections and senders are open.</exception>
    public void OpenConnection(TimeSpan time, RecordedConnection connection)
    {
        ArgumentNullException.ThrowIfNull(connection);
        RequireNumber(connection.Number, nameof(connection));
        if (connection.Transport is not (TransportKind.Tcp or TransportKind.Udp))
            throw new ArgumentOutOfRangeException(nameof(connection), connection.Transport, "The transport is not defined.");

        RecordedConnection known = connection with { Local = RecordingLayout.CutText(connection.Local), Remote = RecordingLayout.CutText(connection.Remote) };
        _state.Open(known);
        _entries.AddOpened(Advance(time), known);
        EndEntry();
    }

    /// <summary>Records a new sender, whose datagrams have this number from now on.</summary>
    /// <param name="time">The time since <see cref="StartTime"/>.</param>
    /// <param name="connection">Number of the connection.</param>
    /// <param name="sender">Number of the sender, from 0, new in this connection.</param>
    /// <param name="address">Address and port of the sender, truncated to 255 bytes.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is negative.</exception>
    /// <exception cref="InvalidOperationException">
    /// The connection is not open or already has that sender, or 1024 connections and senders are open.
    /// </exception>
    public void AddSender(TimeSpan time, int connection, int sender, string address)
    {
        ArgumentNullException.ThrowIfNull(address);
        RequireNumber(connection, nameof(connection));
        RequireNumber(sender, nameof(sender));
        string known = RecordingLayout.CutText(address);
        _state.AddSender(connection, sender, known);
        _entries.AddSender(Advance(time), connection, sender, known);
        EndEntry();
    }

    /// <summary>Records that a sender was forgotten.</summary>
    /// <param name="time">The time since <see cref="StartTime"/>.</param>
    /// <param name="connection">Number of the connection.</param>
    /// <param name="sender">Number of the sender.</param>
    /// <exception cref="InvalidOperationException">The sender does not exist.</exception>
    public void RemoveSender(TimeSpan time, int connection, int sender)
    {
        _state.RemoveSender(connection, sender);
        _entries.AddSenderRemoved(Advance(time), connection, sender);
        EndEntry();
    }

    /// <summary>
    /// Records a piece of received bytes. After the largest piece, this allocates memory only for compressed blocks and, after each MiB, for a
    /// checkpoint.
    /// </summary>
    /// <param name="time">The time of receipt since <see cref="StartTime"/>.</param>
    /// <param name="connection">Number of the connection.</param>
    /// <param name="bytes">The bytes, at most <see cref="MaxPieceLength"/>; may be empty.</param>
    /// <param name="sender">Over UDP, the number of the sender.</param>
    /// <exception cref="ArgumentException">The piece is too large, or a number is negative.</exception>
    public void WriteBytes(TimeSpan time, int connection, ReadOnlySpan<byte> bytes, int sender = 0)
    {
        if (bytes.Length > MaxPieceLength)
            throw new ArgumentException($"A piece must not have more than {MaxPieceLength} bytes; this one has {bytes.Length}.", nameof(bytes));
        if (connection < 0 || sender < 0)
            throw new ArgumentException("The numbers of connections and senders must not be negative.", nameof(connection));

        _entries.AddBytes(Advance(time), connection, sender, bytes);
        _totals = _totals with { Pieces = _totals.Pieces + 1, Bytes = _totals.Bytes + bytes.Length };
        EndEntry();
    }

    /// <summary>Records that received bytes are missing from the recording.</summary>
    /// <param name="time">The time since <see cref="StartTime"/> at which the bytes are missing.</param>
    /// <param name="connection">Number of the connection.</param>
    /// <param name="pieces">Number of missing pieces.</param>
    /// <param name="bytes">Number of missing bytes.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is negative.</exception>
    public void WriteLoss(TimeSpan time, int connection, long pieces, long bytes)
    {
        if (connection < 0 || pieces < 0 || bytes < 0)
            throw new ArgumentOutOfRangeException(nameof(pieces), "The numbers of connections, pieces and bytes must not be negative.");

        _entries.AddLoss(Advance(time), connection, pieces, bytes);
        _totals = _totals with { LostPieces = _totals.LostPieces + pieces, LostBytes = _totals.LostBytes + bytes };
        EndEntry();
    }

    /// <summary>Records that a connection was closed.</summary>
    /// <param name="time">The time since <see cref="StartTime"/>.</param>
    /// <param name="connection">Number of the connection.</param>
    /// <param name="reason">The reason, truncated to 255 bytes.</param>
    /// <exception cref="InvalidOperationException">The connection is not open.</exception>
    public void CloseConnection(TimeSpan time, int connection, string reason)
    {
        ArgumentNullException.ThrowIfNull(reason);
        _state.Close(connection);
        _entries.AddClosed(Advance(time), connection, RecordingLayout.CutText(reason));
        EndEntry();
    }

    /// <summary>Records a metadata value that was not known before. A value that is already known is not written again.</summary>
    /// <param name="time">The time since <see cref="StartTime"/> at which the value became known.</param>
    /// <param name="key">The key.</param>
    /// <param name="value">The value.</param>
    /// <exception cref="ArgumentException">A limit of <see cref="RecordingMetadata"/> is exceeded.</exception>
    public void SetMetadata(TimeSpan time, string key, string value)
    {
        ArgumentNullException.ThrowIfNull(key);
        if (string.Equals(_state.Metadata[key], value, StringComparison.Ordinal))
            return;

        _state.Metadata = _state.Metadata.With(key, value);
        _entries.AddMetadata(Advance(time), key, value);
        _isStateNew = true;
        EndEntry();
    }

    /// <summary>Writes the collected entries and flushes the stream. Entries written so far survive the end of this process.</summary>
    public void Flush()
    {
        ObjectDisposedException.ThrowIf(_isDisposed, this);
        WriteEntries();
        _blocks.Flush();
    }

    /// <summary>Writes the collected entries, the index and the end block, and closes the stream.</summary>
    public void Dispose()
    {
        if (_isDisposed)
            return;

        _isDisposed = true;
        try
        {
            if (!_blocks.HasFailed)
                WriteEnd();
        }
        finally
        {
            _blocks.Dispose();
        }
    }

    private static void RequireNumber(int number, string name)
    {
        if (number < 0)
            throw new ArgumentOutOfRangeException(name, number, "The numbers of connections and senders must not be negative.");
    }

    private long Advance(TimeSpan time)
    {
        ObjectDisposedException.ThrowIf(_isDisposed, this);
        return _time = Math.Clamp(time.Ticks, _time, RecordingLayout.MaxTime);
    }

    private void EndEntry()
    {
        if (_entries.Length >= RecordingLayout.BlockSize)
            WriteEntries();
    }

    private void WriteEntries()
    {
        if (_entries.IsEmpty)
            return;

        _blocks.Write(BlockKind.Entries, _entries, _entries.FirstTime);
        if (_blocks.HasFailed)
            return;

        (_writtenTotals, _writtenTime) = (_totals, _time);
        if (_isStateNew || WrittenLength - _lastCheckpoint >= CheckpointDistance)
            WriteCheckpointWithinBounds();
    }

    private void WriteCheckpointWithinBounds()
    {
        long allowed = CheckpointAllowance + (WrittenLength / CheckpointShare);
        if (_checkpointBytes < allowed)
            WriteCheckpoint();
    }

    private void WriteCheckpoint()
    {
        _index.Add(_time, WrittenLength);
        long before = WrittenLength;
        _state.Write(_checkpoint, _time);
        _blocks.Write(BlockKind.Checkpoint, _checkpoint, _checkpoint.IsEmpty ? _time : _checkpoint.FirstTime);
        _checkpointLength = WrittenLength - before;
        _checkpointBytes += _checkpointLength;
        _lastCheckpoint = WrittenLength;
        _isStateNew = false;
    }

    private void WriteEnd()
    {
        WriteEntries();
        if (_isStateNew)
            WriteCheckpoint();

        var payload = new ByteBuffer(1024);
        _ = payload.Extend(RecordingLayout.BlockHeaderSize);
        _index.Write(payload);
        var end = new RecordingEnd(WrittenLength, _time, _totals);
        _blocks.Write(BlockKind.Index, payload, _time);

        payload.Length = RecordingLayout.BlockHeaderSize;
        end.Write(payload.Extend(RecordingEnd.Size));
        _blocks.Write(BlockKind.End, payload, _time);
        _blocks.Flush();
    }
}
