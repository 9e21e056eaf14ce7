using System.Text;
using NeuronMocap.Files;

namespace NeuronMocap.Recording;

/// <summary>
/// Writes a recording (docs/reference/recording.md). Entries are gathered in blocks; a block is written whole, with one call, when it has grown to 64 KB or
/// <see cref="Flush"/> is called, and nothing that was written is ever changed. Times must not go back: one that does counts as the time of the entry
/// before. Not for use by several threads at a time. Exceptions of the stream are handed on. After one the writer writes no more, and the file ends behind
/// the last whole block.
/// </summary>
public sealed class RecordingWriter : IDisposable
{
    /// <summary>Most bytes of one piece.</summary>
    public const int MaxPieceLength = RecordingLayout.MaxPiece;

    // Checkpoints come every MiB, and when the metadata have changed, as long as they stay below a thousandth of the file and this.
    private const long CheckpointDistance = 1024 * 1024;
    private const long CheckpointAllowance = 16 * 1024;
    private const int CheckpointShare = 1000;

    // Behind the last entry, beside the index: its header, the end, the header of the last block and what stands in front of a piece.
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

    /// <summary>Begins a recording.</summary>
    /// <param name="stream">Where to; only written to, from where it stands on, which has to be the beginning of the file.</param>
    /// <param name="metadata">What is known already; null for nothing.</param>
    /// <param name="options">How to write; null for the defaults.</param>
    /// <exception cref="ArgumentException">The stream cannot be written to.</exception>
    public RecordingWriter(Stream stream, RecordingMetadata? metadata = null, RecordingWriterOptions? options = null)
        : this(stream, new RecordingState(metadata ?? RecordingMetadata.Empty), options ?? new RecordingWriterOptions())
    {
    }

    private RecordingWriter(Stream stream, RecordingState state, RecordingWriterOptions options)
    {
        ArgumentNullException.ThrowIfNull(stream);
        if (!stream.CanWrite)
            throw new ArgumentException("The stream cannot be written to.", nameof(stream));

        _state = state;
        _header = new RecordingHeader(
            (options.StartTime ?? DateTimeOffset.UtcNow).ToUniversalTime(),
            options.RecordingId == Guid.Empty ? Guid.NewGuid() : options.RecordingId,
            options.FileNumber);
        _blocks = new BlockWriter(stream, _header, options.Compress, options.LeaveOpen);
        WriteCheckpoint();
    }

    /// <summary>The moment that all times count from, in UTC.</summary>
    public DateTimeOffset StartTime => _header.StartTime;

    /// <summary>What the files of one recording have in common.</summary>
    public Guid RecordingId => _header.RecordingId;

    /// <summary>Which file of the recording this is, from 1.</summary>
    public int FileNumber => _header.FileNumber;

    /// <summary>Time of the newest entry.</summary>
    public TimeSpan Duration => new(_time);

    /// <summary>Bytes of the file so far, those included that are not yet written.</summary>
    public long Length => WrittenLength + (_entries.IsEmpty ? 0 : _entries.Block.Length);

    // No less than the file would have, closed behind one more piece.
    internal long LengthWith(int piece) =>
        Length + piece + ClosingBytes + (2 * _checkpointLength) + (IndexPlaceBytes * (long)(_index.Count + 1));

    /// <summary>Bytes that the stream has taken, in whole blocks.</summary>
    public long WrittenLength => _blocks.Length;

    /// <summary>What the file holds so far.</summary>
    public RecordingTotals Totals => _totals;

    // What the blocks hold that the stream has taken.
    internal RecordingTotals WrittenTotals => _writtenTotals;

    // Time of the newest entry in them.
    internal TimeSpan WrittenDuration => new(_writtenTime);

    /// <summary>What is known about the recording.</summary>
    public RecordingMetadata Metadata => _state.Metadata;

    /// <summary>Begins a recording in a new file.</summary>
    /// <param name="path">The file; its usual extension is ".nmrec".</param>
    /// <param name="metadata">What is known already; null for nothing.</param>
    /// <param name="options">How to write; null for the defaults.</param>
    /// <returns>The writer; disposing of it closes the file.</returns>
    /// <exception cref="IOException">The file exists, or cannot be made or written.</exception>
    /// <exception cref="UnauthorizedAccessException">The file may not be made.</exception>
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
    /// Begins the next file of the same recording, which is whole by itself: it has the metadata and what is open now at its head. This writer is
    /// left as it is. The new one's times count from its own beginning.
    /// </summary>
    /// <param name="stream">The next file.</param>
    /// <param name="time">When it begins, in this writer's time.</param>
    /// <returns>The writer of the next file.</returns>
    public RecordingWriter ContinueIn(Stream stream, TimeSpan time) => new(
        stream,
        _state.Copy(),
        new RecordingWriterOptions
        {
            StartTime = StartTime + time,
            Compress = _blocks.Compress,
            LeaveOpen = _blocks.LeaveOpen,
            RecordingId = RecordingId,
            FileNumber = FileNumber + 1,
        });

    /// <summary>Tells that a connection stands.</summary>
    /// <param name="time">When, since <see cref="StartTime"/>.</param>
    /// <param name="connection">The connection; its end points are cut to 255 bytes.</param>
    /// <exception cref="InvalidOperationException">A connection of that number is open, or 1024 connections and senders are.</exception>
    public void OpenConnection(TimeSpan time, RecordedConnection connection)
    {
        ArgumentNullException.ThrowIfNull(connection);
        RecordedConnection known = connection with { Local = Cut(connection.Local), Remote = Cut(connection.Remote) };
        _state.Open(known);
        _entries.AddOpened(Advance(time), known);
        EndEntry();
    }

    /// <summary>Tells whose datagrams have this number from here on.</summary>
    /// <param name="time">When, since <see cref="StartTime"/>.</param>
    /// <param name="connection">Number of the connection.</param>
    /// <param name="sender">Number of the sender, from 0, new in this connection.</param>
    /// <param name="address">Its address and port; cut to 255 bytes.</param>
    /// <exception cref="InvalidOperationException">The connection is not open, or has that sender, or 1024 connections and senders are open.</exception>
    public void AddSender(TimeSpan time, int connection, int sender, string address)
    {
        ArgumentNullException.ThrowIfNull(address);
        string known = Cut(address);
        _state.AddSender(connection, sender, known);
        _entries.AddSender(Advance(time), connection, sender, known);
        EndEntry();
    }

    /// <summary>Tells that a sender was forgotten.</summary>
    /// <param name="time">When, since <see cref="StartTime"/>.</param>
    /// <param name="connection">Number of the connection.</param>
    /// <param name="sender">Number of the sender.</param>
    /// <exception cref="InvalidOperationException">There is no such sender.</exception>
    public void RemoveSender(TimeSpan time, int connection, int sender)
    {
        _state.RemoveSender(connection, sender);
        _entries.AddSenderRemoved(Advance(time), connection, sender);
        EndEntry();
    }

    /// <summary>Writes a piece of bytes as it arrived. Allocates nothing once the largest piece has been seen, but for compressed blocks and, after each MiB, a checkpoint.</summary>
    /// <param name="time">When it arrived, since <see cref="StartTime"/>.</param>
    /// <param name="connection">Number of the connection.</param>
    /// <param name="bytes">The bytes, at most <see cref="MaxPieceLength"/>; there may be none.</param>
    /// <param name="sender">Over UDP, number of the sender.</param>
    /// <exception cref="ArgumentException">The piece is too large, or a number negative.</exception>
    public void WriteBytes(TimeSpan time, int connection, ReadOnlySpan<byte> bytes, int sender = 0)
    {
        if (bytes.Length > MaxPieceLength)
            throw new ArgumentException($"A piece may have {MaxPieceLength} bytes; this has {bytes.Length}.", nameof(bytes));
        if (connection < 0 || sender < 0)
            throw new ArgumentException("Connections and senders are numbered from 0.", nameof(connection));

        _entries.AddBytes(Advance(time), connection, sender, bytes);
        _totals = _totals with { Pieces = _totals.Pieces + 1, Bytes = _totals.Bytes + bytes.Length };
        EndEntry();
    }

    /// <summary>Tells that bytes arrived which the recording does not hold.</summary>
    /// <param name="time">When, since <see cref="StartTime"/>: at the place where they are missing.</param>
    /// <param name="connection">Number of the connection.</param>
    /// <param name="pieces">How many pieces.</param>
    /// <param name="bytes">How many bytes.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is negative.</exception>
    public void WriteLoss(TimeSpan time, int connection, long pieces, long bytes)
    {
        if (connection < 0 || pieces < 0 || bytes < 0)
            throw new ArgumentOutOfRangeException(nameof(pieces), "Numbers of connections, pieces and bytes are not negative.");

        _entries.AddLoss(Advance(time), connection, pieces, bytes);
        _totals = _totals with { LostPieces = _totals.LostPieces + pieces, LostBytes = _totals.LostBytes + bytes };
        EndEntry();
    }

    /// <summary>Tells that a connection is gone.</summary>
    /// <param name="time">When, since <see cref="StartTime"/>.</param>
    /// <param name="connection">Number of the connection.</param>
    /// <param name="reason">Why; cut to 255 bytes.</param>
    /// <exception cref="InvalidOperationException">The connection is not open.</exception>
    public void CloseConnection(TimeSpan time, int connection, string reason)
    {
        ArgumentNullException.ThrowIfNull(reason);
        _state.Close(connection);
        _entries.AddClosed(Advance(time), connection, Cut(reason));
        EndEntry();
    }

    /// <summary>Tells something about the recording that was not known before. A value that is known already is not written again.</summary>
    /// <param name="time">When it came to be known, since <see cref="StartTime"/>.</param>
    /// <param name="key">The name.</param>
    /// <param name="value">The value.</param>
    /// <exception cref="ArgumentException">One of the limits of <see cref="RecordingMetadata"/> is exceeded.</exception>
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

    /// <summary>Writes what was gathered, and flushes the stream. What was written before survives the end of this process.</summary>
    public void Flush()
    {
        ObjectDisposedException.ThrowIf(_isDisposed, this);
        WriteEntries();
        _blocks.Flush();
    }

    /// <summary>Writes what was gathered, the index and the end, and closes the stream.</summary>
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

    private static string Cut(string text)
    {
        if (Encoding.UTF8.GetByteCount(text) <= RecordingLayout.MaxTextBytes)
            return text;

        int length = RecordingLayout.MaxTextBytes;
        while (Encoding.UTF8.GetByteCount(text.AsSpan(0, Math.Min(length, text.Length))) > RecordingLayout.MaxTextBytes)
            length--;

        return text[..length];
    }
}
