namespace NeuronMocap.Bvh;

/// <summary>
/// Reads a BVH file of any length as it arrives: first the hierarchy, then one row at a time into the caller's memory.
/// </summary>
/// <remarks>
/// <para>
/// The result is exactly that of <see cref="BvhDocument"/>. The text can come from a file, a pipe or a connection, in pieces of any size.
/// </para>
/// <para>
/// The reader holds 128 KiB of the text and no rows. Numbers are parsed without strings, and reading a row does not allocate memory. Calls block
/// while the stream has no data. Not thread-safe.
/// </para>
/// </remarks>
public sealed class BvhReader : IDisposable
{
    private readonly Stream _stream;
    private readonly bool _leaveOpen;
    private readonly BvhTextSource _source;
    private readonly BvhParser _parser;
    private bool _isBroken;
    private bool _isDisposed;

    /// <summary>Reads the hierarchy of a stream, and the declarations up to the first row.</summary>
    /// <param name="stream">The stream to read, from its current position. It does not have to be seekable.</param>
    /// <param name="options">The options; null for the defaults.</param>
    /// <param name="leaveOpen">
    /// Whether the stream stays open when the reader is disposed. If this constructor throws, the stream always stays open.
    /// </param>
    /// <exception cref="BvhFormatException">
    /// The text is not BVH or exceeds a limit. With <see cref="BvhReadOptions.Strict"/>: the text has a defect.
    /// </exception>
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
    /// Time from one frame to the next, see <see cref="BvhDocument.FrameTime"/>. It is 1/120 s until a usable frame time is read; a well-formed
    /// file has one before the first row.
    /// </summary>
    public BvhFrameTime FrameTime => _parser.FrameTime;

    /// <summary>Seconds from one frame to the next as written in the file, often rounded; 0 until a usable frame time is read.</summary>
    public double DeclaredFrameTime => _parser.DeclaredFrameTime;

    /// <summary>
    /// Number of frames that the file declares; null until a valid number is read. Files may hold more or fewer frames than they declare. Use this
    /// number to show progress, not to allocate memory.
    /// </summary>
    public long? DeclaredFrameCount => _parser.AnnouncedFrames;

    /// <summary>Number of rows read so far.</summary>
    public long FrameCount { get; private set; }

    /// <summary>The text layout, as far as the file was read. Properties of rows are known after the first row.</summary>
    public BvhTextFormat TextFormat => _parser.GetTextFormat(_source.Cursor.LineEnd);

    /// <summary>The first hundred defects found so far, and how each was read. The list grows while rows are read.</summary>
    public IReadOnlyList<BvhRepair> Repairs => _parser.Repairs.Listed;

    /// <summary>Number of repairs so far, including those that <see cref="Repairs"/> does not list.</summary>
    public int RepairCount => _parser.Repairs.Count;

    /// <summary>Number of bytes taken from the stream so far, up to 128 KiB more than were parsed.</summary>
    public long BytesRead => _source.BytesRead;

    /// <summary>Number of bytes available in the stream at the start; null when unknown.</summary>
    public long? Length { get; }

    /// <summary>
    /// Opens a file, and reads the hierarchy and the declarations up to the first row. Other programs may write to the file at the same time.
    /// </summary>
    /// <param name="path">The path of the file.</param>
    /// <param name="options">The options; null for the defaults.</param>
    /// <returns>The reader, which keeps the file open.</returns>
    /// <exception cref="BvhFormatException">
    /// The text is not BVH or exceeds a limit. With <see cref="BvhReadOptions.Strict"/>: the text has a defect.
    /// </exception>
    /// <exception cref="IOException">The file does not exist or cannot be read.</exception>
    /// <exception cref="UnauthorizedAccessException">The user does not have permission to read the file.</exception>
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
    /// <param name="values">Receives <see cref="BvhHierarchy.ChannelCount"/> values. At the end, the content is undefined.</param>
    /// <returns>True if a row was read; false at the end.</returns>
    /// <exception cref="ArgumentException">The span is too short.</exception>
    /// <exception cref="BvhFormatException">With <see cref="BvhReadOptions.Strict"/>: the text has a defect.</exception>
    /// <exception cref="IOException">The stream fails.</exception>
    /// <exception cref="InvalidOperationException">An earlier exception ended the reading.</exception>
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

    /// <summary>Closes the stream, unless the reader was created with leaveOpen.</summary>
    public void Dispose()
    {
        _isDisposed = true;
        _source.Release();
        if (!_leaveOpen)
            _stream.Dispose();
    }

    // Without a second buffer.
    internal static FileStream OpenFile(string path) =>
        new(path, FileMode.Open, FileAccess.Read, FileShare.ReadWrite | FileShare.Delete, bufferSize: 1, FileOptions.SequentialScan);
}
