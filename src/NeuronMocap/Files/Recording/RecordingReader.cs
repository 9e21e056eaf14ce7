namespace NeuronMocap.Recording;

/// <summary>
/// Reads a recording (docs/reference/recording.md), entry by entry, in constant memory: about as much as the largest block has, 2 MB at most, and 4 MB more where
/// blocks are missing or displaced. A file that was not closed, because the recording process was killed or still runs, is read up to its last whole block;
/// damaged and missing places are passed over and told (<see cref="Problems"/>, <see cref="RecordingEntryKind.Damaged"/>), and blocks that are not in the order in
/// which they were written are read in that order, each once. Not for use by several threads at a time.
/// </summary>
public sealed class RecordingReader : IDisposable
{
    private static readonly string TooManyOpen =
        FormattableString.Invariant($"More than {RecordingLayout.MaxOpen} connections and senders are open; those beyond are passed over.");

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

    // Whether what a checkpoint repeats is news: at the beginning, behind a jump, and behind a damaged place.
    private bool _isStateUnknown = true;

    private RecordingReader(Stream stream, bool leaveOpen)
    {
        _stream = stream;
        _leaveOpen = leaveOpen;
        _file = new BlockFile(stream);
        _map = new RecordingMap(_file);
        _walk = new BlockIterator(_file, _problems);
        if (_map.LacksEnd)
            _problems.Add(_file.Length, 0, "The last block is missing, which ends a recording that was closed.");
    }

    /// <summary>The moment that all times count from, in UTC.</summary>
    public DateTimeOffset StartTime => _file.Header.StartTime;

    /// <summary>What the files of one recording have in common.</summary>
    public Guid RecordingId => _file.Header.RecordingId;

    /// <summary>Which file of the recording this is, from 1.</summary>
    public int FileNumber => _file.Header.FileNumber;

    /// <summary>Time of the last entry.</summary>
    public TimeSpan Duration => new(_map.Duration);

    /// <summary>
    /// What is known about the recording, at its end. Where <see cref="IsComplete"/> is false, what came to be known late may be missing here, and
    /// comes as an entry.
    /// </summary>
    public RecordingMetadata Metadata => _map.Metadata;

    /// <summary>Whether the recording was closed in an orderly way. If not, its last part may be missing: what was not yet written then.</summary>
    public bool IsComplete => _map.Totals is not null;

    /// <summary>What the recording holds; null when it was not closed.</summary>
    public RecordingTotals? Totals => _map.Totals;

    /// <summary>Time of the entry that was read last, or the time that the reader was moved to.</summary>
    public TimeSpan Position => new(_time);

    /// <summary>What was found wrong with the file in the parts that were read so far: the first 100.</summary>
    public IReadOnlyList<RecordingProblem> Problems => _problems.All;

    /// <summary>Whether a file is a recording, as its first bytes tell.</summary>
    /// <param name="start">The first bytes of the file, eight or more.</param>
    /// <returns>Whether it begins as one; whether it can be read, only opening tells.</returns>
    public static bool IsRecording(ReadOnlySpan<byte> start) =>
        start.Length >= RecordingHeader.MagicSize && RecordingHeader.HasMagic(start[..RecordingHeader.MagicSize]);

    /// <summary>Opens a file. It may still be written to; what is written from now on is not read.</summary>
    /// <param name="path">The file.</param>
    /// <returns>The reader, before the first entry.</returns>
    /// <exception cref="RecordingFormatException">It is no recording, or its first 64 bytes are damaged.</exception>
    /// <exception cref="IOException">The file cannot be read.</exception>
    /// <exception cref="UnauthorizedAccessException">The file may not be read.</exception>
    public static RecordingReader Open(string path)
    {
        var stream = new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.ReadWrite | FileShare.Delete, bufferSize: 1);
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

    // Whether it begins as one; the position is 0 afterwards.
    internal static bool IsRecording(Stream stream)
    {
        Span<byte> start = stackalloc byte[RecordingHeader.MagicSize];
        stream.Position = 0;
        int count = stream.Read(start);
        stream.Position = 0;
        return RecordingHeader.HasMagic(start[..count]);
    }

    /// <summary>Opens a recording.</summary>
    /// <param name="stream">A stream that can be read and seek; the recording begins at its position 0.</param>
    /// <param name="leaveOpen">Whether the stream stays open when the reader is disposed of.</param>
    /// <returns>The reader, before the first entry.</returns>
    /// <exception cref="ArgumentException">The stream cannot be read or cannot seek.</exception>
    /// <exception cref="RecordingFormatException">It is no recording, or its first 64 bytes are damaged.</exception>
    public static RecordingReader Open(Stream stream, bool leaveOpen = false)
    {
        ArgumentNullException.ThrowIfNull(stream);
        if (!stream.CanRead || !stream.CanSeek)
            throw new ArgumentException("The stream has to be one that can be read and seek.", nameof(stream));

        return new RecordingReader(stream, leaveOpen);
    }

    /// <summary>Reads the next entry.</summary>
    /// <param name="entry">The entry; valid until the next call.</param>
    /// <returns>False at the end.</returns>
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
                _problems.Add(_walk.Offset, RecordingLayout.BlockHeaderSize + _walk.Header.Length, "The block holds what no recorder writes.");
            }

            if (!TryMoveOn())
                return false;
            if (TryReportDamage(out entry))
                return true;
        }
    }

    /// <summary>
    /// Moves to a time. What is read next are the entries that tell what is open there and known about the recording, with their own times or that
    /// of a checkpoint, and then everything from that time on.
    /// </summary>
    /// <param name="position">The time, since <see cref="StartTime"/>; behind the end, nothing but the state follows.</param>
    /// <exception cref="ArgumentOutOfRangeException">The time is negative.</exception>
    public void Seek(TimeSpan position)
    {
        if (position < TimeSpan.Zero)
            throw new ArgumentOutOfRangeException(nameof(position), position, "A recording begins at time zero.");

        _walk.MoveTo(position.Ticks, _map.Index.Count > 0 ? _map.Index.Find(position.Ticks) : RecordingLayout.FileHeaderSize);
        _open.Clear();
        _from = position.Ticks;
        _time = 0;
        _isStateUnknown = true;
        _decoder.End();
    }

    /// <summary>Closes the stream, unless it was to stay open.</summary>
    public void Dispose()
    {
        if (!_leaveOpen)
            _stream.Dispose();
    }

    private static bool IsTraffic(RecordingEntryKind kind) => kind is RecordingEntryKind.Bytes or RecordingEntryKind.BytesLost;

    // To the next block that has entries to tell.
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

    // Before what follows the damaged or missing place.
    private bool TryReportDamage(out RecordingEntry entry)
    {
        entry = new RecordingEntry { Kind = RecordingEntryKind.Damaged, Time = new TimeSpan(_time), LostBytes = _walk.DamagedBytes };
        bool isBroken = _walk.IsBroken;
        _walk.ForgetBreak();
        return isBroken;
    }
}
