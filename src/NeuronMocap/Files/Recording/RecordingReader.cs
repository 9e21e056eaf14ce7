namespace NeuronMocap.Recording;

/// <summary>
/// Reads a recording entry by entry, in constant memory (docs/reference/recording.md). Not thread-safe.
/// </summary>
/// <remarks>
/// <para>
/// The memory is about that of the largest block: 2 MB at most, and 4 MB more if blocks are missing or displaced.
/// </para>
/// <para>
/// A file that was not closed is read up to its last whole block. This happens when the recording process was killed or is still running. Damaged
/// and missing sections are skipped and reported (<see cref="Problems"/>, <see cref="RecordingEntryKind.Damaged"/>). Blocks out of order are read
/// in the order of their numbers, each once.
/// </para>
/// </remarks>
public sealed class RecordingReader : IDisposable
{
    private static readonly string TooManyOpen =
        FormattableString.Invariant($"More than {RecordingLayout.MaxOpen} connections and senders are open; the excess is skipped.");

    private readonly Stream _stream;
    private readonly bool _leaveOpen;
    private readonly BlockFile _file;
    private readonly RecordingMap _map;
    private readonly EntryDecoder _decoder = new();
    private readonly BlockIterator _walk;
    private readonly OpenEntries _open = new();
    private readonly RecordingProblems _problems = new();
    private long _time;
    private long _from;

    // Whether the entries of a checkpoint are new to the caller: at the beginning, after a jump, and after a damaged section.
    private bool _isStateUnknown = true;

    private RecordingReader(Stream stream, bool leaveOpen)
    {
        _stream = stream;
        _leaveOpen = leaveOpen;
        _file = new BlockFile(stream);
        _map = new RecordingMap(_file);
        _walk = new BlockIterator(_file, _problems);
        if (_map.LacksEnd)
            _problems.Add(_file.Length, 0, "The recording was closed, but its last block is missing.");
    }

    /// <summary>The start of the recording, in UTC. All times are relative to it.</summary>
    public DateTimeOffset StartTime => _file.Header.StartTime;

    /// <summary>Identifies the recording. All of its files have the same value.</summary>
    public Guid RecordingId => _file.Header.RecordingId;

    /// <summary>Number of this file within the recording, from 1.</summary>
    public int FileNumber => _file.Header.FileNumber;

    /// <summary>Time of the last entry.</summary>
    public TimeSpan Duration => new(_map.Duration);

    /// <summary>
    /// The metadata at the end of the recording. If <see cref="IsComplete"/> is false, values that became known late may be missing here; they are
    /// read as entries.
    /// </summary>
    public RecordingMetadata Metadata => _map.Metadata;

    /// <summary>Whether the recording was closed properly. If not, its last part may be missing, because it was not yet written.</summary>
    public bool IsComplete => _map.Totals is not null;

    /// <summary>The totals of the recording; null when it was not closed.</summary>
    public RecordingTotals? Totals => _map.Totals;

    /// <summary>Time of the last entry read, or the time that the reader was moved to.</summary>
    public TimeSpan Position => new(_time);

    /// <summary>The first hundred defects in the parts of the file that were read so far.</summary>
    public IReadOnlyList<RecordingProblem> Problems => _problems.All;

    /// <summary>Determines from its first bytes whether a file is a recording.</summary>
    /// <param name="start">The first bytes of the file, eight or more.</param>
    /// <returns>True if the file begins like a recording. Only opening shows whether it can be read.</returns>
    public static bool IsRecording(ReadOnlySpan<byte> start) =>
        start.Length >= RecordingHeader.MagicSize && RecordingHeader.HasMagic(start[..RecordingHeader.MagicSize]);

    /// <summary>Opens a file. The file may still be written to; data written after this call is not read.</summary>
    /// <param name="path">The path of the file.</param>
    /// <returns>The reader, positioned before the first entry.</returns>
    /// <exception cref="RecordingFormatException">The file is not a recording, or its first 64 bytes are damaged.</exception>
    /// <exception cref="IOException">The file cannot be read, or is a pipe.</exception>
    /// <exception cref="UnauthorizedAccessException">The user does not have permission to read the file.</exception>
    public static RecordingReader Open(string path)
    {
        FileStream stream = OpenFile(path);
        try
        {
            return Open(stream);
        }
        catch
        {
            stream.Dispose();
            throw;
        }
    }

    // Another program may still be writing the file.
    internal static FileStream OpenFile(string path)
    {
        var file = new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.ReadWrite | FileShare.Delete, bufferSize: 1);
        if (file.CanSeek)
            return file;

        file.Dispose();
        throw new IOException($"'{path}' is a pipe or a device. Copy it to a file first.");
    }

    // Whether the stream begins like a recording. The position is 0 afterwards.
    internal static bool IsRecording(Stream stream)
    {
        Span<byte> start = stackalloc byte[RecordingHeader.MagicSize];
        stream.Position = 0;
        int count = stream.Read(start);
        stream.Position = 0;
        return RecordingHeader.HasMagic(start[..count]);
    }

    /// <summary>Opens a recording from a stream.</summary>
    /// <param name="stream">A readable and seekable stream. The recording begins at its position 0.</param>
    /// <param name="leaveOpen">Whether the stream stays open when the reader is disposed.</param>
    /// <returns>The reader, positioned before the first entry.</returns>
    /// <exception cref="ArgumentException">The stream is not readable or not seekable.</exception>
    /// <exception cref="RecordingFormatException">The stream is not a recording, or its first 64 bytes are damaged.</exception>
    public static RecordingReader Open(Stream stream, bool leaveOpen = false)
    {
        ArgumentNullException.ThrowIfNull(stream);
        if (!stream.CanRead || !stream.CanSeek)
            throw new ArgumentException("The stream must be readable and seekable.", nameof(stream));

        return new RecordingReader(stream, leaveOpen);
    }

    /// <summary>Reads the next entry.</summary>
    /// <param name="entry">The entry; valid until the next call.</param>
    /// <returns>True if an entry was read; false at the end.</returns>
    public bool TryRead(out RecordingEntry entry)
    {
        while (true)
        {
            while (_decoder.TryTake(out entry))
            {
                if (entry.Time.Ticks < _from && IsTraffic(entry.Kind))
                    continue;

                if (!_open.Accepts(entry))
                {
                    _problems.Add(_walk.Offset, 0, TooManyOpen);
                    continue;
                }

                _time = Math.Max(_time, entry.Time.Ticks);
                entry = entry with { Time = new TimeSpan(_time) };
                return true;
            }

            if (_decoder.Remaining > 0)
            {
                _decoder.End();
                _problems.Add(_walk.Offset, RecordingLayout.BlockHeaderSize + _walk.Header.Length, "The block contains data that no recorder writes.");
            }

            if (!TryMoveOn())
                return false;
            if (TryReportDamage(out entry))
                return true;
        }
    }

    /// <summary>
    /// Moves to a time. The next entries describe the open connections, the senders and the metadata at that time. They have their own times or
    /// that of a checkpoint. All entries from that time on follow.
    /// </summary>
    /// <param name="position">The time since <see cref="StartTime"/>. After the end, only the descriptions follow.</param>
    /// <exception cref="ArgumentOutOfRangeException">The time is negative.</exception>
    public void Seek(TimeSpan position)
    {
        if (position < TimeSpan.Zero)
            throw new ArgumentOutOfRangeException(nameof(position), position, "The time must not be negative.");

        _walk.MoveTo(position.Ticks, _map.Index.Count > 0 ? _map.Index.Find(position.Ticks) : RecordingLayout.FileHeaderSize);
        _open.Clear();
        _from = position.Ticks;
        _time = 0;
        _isStateUnknown = true;
        _decoder.End();
    }

    /// <summary>Closes the stream, unless the reader was opened with leaveOpen.</summary>
    public void Dispose()
    {
        if (!_leaveOpen)
            _stream.Dispose();
    }

    private static bool IsTraffic(RecordingEntryKind kind) => kind is RecordingEntryKind.Bytes or RecordingEntryKind.BytesLost;

    // Moves to the next block with entries to return.
    private bool TryMoveOn()
    {
        while (_walk.TryRead(out ArraySegment<byte> payload))
        {
            _isStateUnknown |= _walk.IsBroken;
            BlockHeader header = _walk.Header;
            bool isWanted = header.Kind == BlockKind.Entries || (header.Kind == BlockKind.Checkpoint && _isStateUnknown);
            if (!isWanted)
                continue;

            _isStateUnknown &= header.Kind != BlockKind.Checkpoint;
            _decoder.Begin(payload, header.Time);
            return true;
        }

        return false;
    }

    // Called before the entries that follow the damaged or missing section.
    private bool TryReportDamage(out RecordingEntry entry)
    {
        entry = new RecordingEntry { Kind = RecordingEntryKind.Damaged, Time = new TimeSpan(_time), LostBytes = _walk.DamagedBytes };
        bool isBroken = _walk.IsBroken;
        _walk.ForgetBreak();
        return isBroken;
    }
}
