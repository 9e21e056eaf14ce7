namespace NeuronMocap.Bvh;

/// <summary>
/// Reads a BVH file of any length as it comes: the hierarchy at once, then one row after the other into your memory. Holds 128 KiB of the text, and
/// neither the rows nor a string for a number; a row costs no allocation. Reads exactly what <see cref="BvhDocument"/> reads, from a file, a
/// pipe or a connection, in pieces of any size. For one thread at a time; blocks while the stream has nothing.
/// </summary>
public sealed class BvhReader : IDisposable
{
    private readonly Stream _stream;
    private readonly bool _leaveOpen;
    private readonly BvhTextSource _source;
    private readonly BvhParser _parser;
    private bool _isBroken;
    private bool _isDisposed;

    /// <summary>Reads the hierarchy of a stream, and what is announced up to the first row.</summary>
    /// <param name="stream">Where the text comes from. Read from where it stands; it need not seek.</param>
    /// <param name="options">How to read it; null for the defaults.</param>
    /// <param name="leaveOpen">Whether the stream stays open when the reader is disposed; where this constructor throws, it does.</param>
    /// <exception cref="BvhFormatException">The text is not BVH or exceeds a limit; with <see cref="BvhReadOptions.Strict"/>, anything is wrong.</exception>
    /// <exception cref="IOException">The stream fails.</exception>
    public BvhReader(Stream stream, BvhReadOptions? options = null, bool leaveOpen = false)
    {
        ArgumentNullException.ThrowIfNull(stream);
        _stream = stream;
        _leaveOpen = leaveOpen;
        _source = new BvhTextSource(stream, options?.Progress);
        _parser = new BvhParser(options);
        try
        {
            Length = _source.Remaining;
            var text = new BvhText(_source);
            _parser.Begin(ref text);
            text.Save();
        }
        catch
        {
            _source.Release();
            throw;
        }
    }

    /// <summary>The joints and their channels.</summary>
    public BvhHierarchy Hierarchy => _parser.Hierarchy;

    /// <summary>
    /// Time from one frame to the next, see <see cref="BvhDocument.FrameTime"/>. 1/120 s until a usable one was read, which in an orderly file is so
    /// from the start.
    /// </summary>
    public BvhFrameTime FrameTime => _parser.FrameTime;

    /// <summary>Seconds from one frame to the next as the file has it, often rounded; 0 as long as none was read that is usable.</summary>
    public double DeclaredFrameTime => _parser.DeclaredFrameTime;

    /// <summary>
    /// Number of frames that the file announces before the first row, or as soon as it does; null when it does not, or with nothing that is a
    /// number from 0. Files announce more or fewer than they have: for a measure of progress, not for memory.
    /// </summary>
    public long? DeclaredFrameCount => _parser.AnnouncedFrames;

    /// <summary>Number of rows read so far.</summary>
    public long FrameCount { get; private set; }

    /// <summary>How the text is laid out, as far as it was read; what shows in rows, from the first row on.</summary>
    public BvhTextFormat TextFormat => _parser.GetTextFormat(_source.Cursor.LineEnd);

    /// <summary>What was wrong so far and how it was read all the same; the first hundred. Grows while rows are read.</summary>
    public IReadOnlyList<BvhRepair> Repairs => _parser.Repairs.Listed;

    /// <summary>Number of repairs so far, those included that <see cref="Repairs"/> does not list.</summary>
    public int RepairCount => _parser.Repairs.Count;

    /// <summary>Bytes taken from the stream so far, up to 128 KiB more than have been looked at.</summary>
    public long BytesRead => _source.BytesRead;

    /// <summary>Bytes that the stream had to offer at the start; null when it does not know.</summary>
    public long? Length { get; }

    /// <summary>Reads the hierarchy of a file, and what is announced up to the first row. Others may write to the file meanwhile.</summary>
    /// <param name="path">Where it is.</param>
    /// <param name="options">How to read it; null for the defaults.</param>
    /// <returns>The reader, which holds the file open.</returns>
    /// <exception cref="BvhFormatException">The text is not BVH or exceeds a limit; with <see cref="BvhReadOptions.Strict"/>, anything is wrong.</exception>
    /// <exception cref="IOException">The file is not there or cannot be read.</exception>
    /// <exception cref="UnauthorizedAccessException">This user may not read it.</exception>
    public static BvhReader Open(string path, BvhReadOptions? options = null)
    {
        FileStream stream = OpenFile(path);
        try
        {
            return new BvhReader(stream, options);
        }
        catch
        {
            stream.Dispose();
            throw;
        }
    }

    /// <summary>Reads the next row.</summary>
    /// <param name="values">
    /// Room for the hierarchy's <see cref="BvhHierarchy.ChannelCount"/> values; what it holds where there is no further row is not defined.
    /// </param>
    /// <returns>False at the end.</returns>
    /// <exception cref="ArgumentException">There is too little room.</exception>
    /// <exception cref="BvhFormatException">With <see cref="BvhReadOptions.Strict"/>: something is wrong.</exception>
    /// <exception cref="IOException">The stream fails.</exception>
    /// <exception cref="InvalidOperationException">An exception ended the reading before.</exception>
    /// <exception cref="ObjectDisposedException">The reader is disposed.</exception>
    public bool TryReadFrame(Span<float> values)
    {
        ObjectDisposedException.ThrowIf(_isDisposed, this);
        if (_isBroken)
            throw new InvalidOperationException("An earlier exception ended the reading.");
        if (values.Length < Hierarchy.ChannelCount)
            throw new ArgumentException($"There must be room for the row's {Hierarchy.ChannelCount} values.", nameof(values));

        _isBroken = true;
        var text = new BvhText(_source);
        bool isRead = _parser.TryReadRow(ref text, values[..Hierarchy.ChannelCount]);
        text.Save();
        _isBroken = false;
        FrameCount += isRead ? 1 : 0;
        return isRead;
    }

    /// <summary>Closes the stream, unless it is to stay open.</summary>
    public void Dispose()
    {
        _isDisposed = true;
        _source.Release();
        if (!_leaveOpen)
            _stream.Dispose();
    }

    // Not buffered a second time.
    internal static FileStream OpenFile(string path) =>
        new(path, FileMode.Open, FileAccess.Read, FileShare.ReadWrite | FileShare.Delete, bufferSize: 1, FileOptions.SequentialScan);
}
