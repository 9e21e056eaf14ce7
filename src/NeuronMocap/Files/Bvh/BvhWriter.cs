using System.Text;
using NeuronMocap.Files;
using NeuronMocap.Protocol;

namespace NeuronMocap.Bvh;

/// <summary>
/// Writes a BVH file row by row, in constant memory. Not thread-safe.
/// </summary>
/// <remarks>
/// <para>
/// Values have as many decimals as the <see cref="BvhTextFormat"/> specifies, or more where the same binary32 value needs them. NaN and infinities
/// are written as <c>NaN</c>, <c>Infinity</c> and <c>-Infinity</c>. Writing a row does not allocate memory.
/// </para>
/// <para>
/// The number of frames is known only at the end. If the stream is seekable, the number and the frame time have fields of a fixed width. Each
/// <see cref="Flush"/> updates these fields after it writes the rows, and so does the end. A file that is cut off at any moment can therefore be
/// opened, with all rows up to the last flush.
/// </para>
/// <para>
/// If the stream fails, for example on a full disk, the file is truncated after the last complete row. <see cref="FrameCount"/> then is the number
/// of rows in the file.
/// </para>
/// <para>
/// If the stream is not seekable, the file contains <c>Frames: 0</c>. <see cref="BvhDocument"/> reads the rows that exist; other programs may not.
/// </para>
/// </remarks>
public sealed class BvhWriter : IDisposable
{
    // Wide enough for any number of frames, and for any frame time with fifteen decimals. A longer text of the first frame time gets a wider place.
    private const int FrameCountWidth = 10;
    private const int FrameTimeWidth = 20;

    private const int BufferSize = 1 << 16;

    private readonly Stream _stream;
    private readonly bool _leavesOpen;
    private readonly BvhTextFormat _format;
    private readonly byte[] _separator;
    private readonly byte[] _rowEnd;
    private readonly int[]? _columns;
    private readonly byte[] _buffer = new byte[BufferSize];
    private readonly byte[] _field;
    private readonly long _countPlace = -1;
    private readonly long _timePlace = -1;
    private readonly long _start;
    private int _length;
    private int _writtenFrameCount;

    // _rowsEnd is the end of the last whole row, or of the header, in the buffer. _takenEnd is the same in the stream, and _takenFrames is the
    // number of rows up to there.
    private int _rowsEnd = -1;
    private long _takenEnd;
    private int _takenFrames;
    // Bytes after _takenEnd that the stream has accepted: the beginning of a row.
    private long _carried;
    private Exception? _failure;
    private BvhFrameTime _frameTime;
    private bool _isTimeStale;
    private bool _isDisposed;

    /// <summary>Creates a file and writes its hierarchy.</summary>
    /// <param name="path">The path of the file. An existing file is replaced.</param>
    /// <param name="hierarchy">The joints.</param>
    /// <param name="frameTime">Time from one frame to the next, above 0.</param>
    /// <param name="format">The text layout; null for <see cref="BvhTextFormat.AxisNeuron"/>.</param>
    /// <exception cref="ArgumentException">The frame time is 0.</exception>
    /// <exception cref="IOException">The file cannot be written.</exception>
    /// <exception cref="UnauthorizedAccessException">The user does not have permission to write the file.</exception>
    public BvhWriter(string path, BvhHierarchy hierarchy, BvhFrameTime frameTime, BvhTextFormat? format = null)
        : this(Create(path, hierarchy, frameTime), hierarchy, frameTime, format)
    {
    }

    /// <summary>Writes a hierarchy to a stream.</summary>
    /// <param name="stream">The stream to write, from its current position.</param>
    /// <param name="hierarchy">The joints.</param>
    /// <param name="frameTime">Time from one frame to the next, above 0.</param>
    /// <param name="format">The text layout; null for <see cref="BvhTextFormat.AxisNeuron"/>.</param>
    /// <param name="leaveOpen">Whether the stream stays open when the writer is disposed.</param>
    /// <exception cref="ArgumentException">The frame time is 0, or the stream is not writable.</exception>
    /// <exception cref="IOException">The stream fails.</exception>
    public BvhWriter(Stream stream, BvhHierarchy hierarchy, BvhFrameTime frameTime, BvhTextFormat? format = null, bool leaveOpen = false)
        : this(stream, hierarchy, frameTime, format, leaveOpen, frameCount: null)
    {
    }

    internal BvhWriter(
        Stream stream, BvhHierarchy hierarchy, BvhFrameTime frameTime, BvhTextFormat? format, bool leaveOpen, int? frameCount)
    {
        ArgumentNullException.ThrowIfNull(stream);
        if (!stream.CanWrite)
            throw new ArgumentException("The stream is not writable.", nameof(stream));

        Check(hierarchy, frameTime);

        _stream = stream;
        _leavesOpen = leaveOpen;
        _format = format ?? BvhTextFormat.AxisNeuron;
        _separator = Encoding.ASCII.GetBytes(_format.Separator);
        _rowEnd = Encoding.ASCII.GetBytes((_format.HasSeparatorAtRowEnd ? _format.Separator : "") + _format.LineEnd);
        _columns = FindColumns(hierarchy);
        _frameTime = frameTime;
        Hierarchy = hierarchy;

        _start = _takenEnd = stream.CanSeek ? stream.Position : 0;
        bool isPatched = frameCount is null && stream.CanSeek;
        WriteText((_format.HasByteOrderMark ? "\uFEFF" : "") + BvhHierarchyText.Create(hierarchy, _format));
        WriteText($"MOTION{_format.LineEnd}{(_format.HasBlankLineAfterMotion ? _format.LineEnd : "")}Frames: ");
        if (isPatched)
            _countPlace = stream.Position + _length;

        WriteText(Padded(Decimal(frameCount ?? 0), isPatched ? FrameCountWidth : 0) + _format.LineEnd + "Frame Time: ");
        string time = TimeText;
        _field = new byte[Math.Max(time.Length, FrameTimeWidth)];
        if (isPatched)
            _timePlace = stream.Position + _length;

        WriteText(Padded(time, isPatched ? _field.Length : 0) + _format.LineEnd);
        _rowsEnd = _length;
    }

    /// <summary>The joints.</summary>
    public BvhHierarchy Hierarchy { get; }

    /// <summary>Number of rows written. If the stream has failed, the number of rows that it holds.</summary>
    public int FrameCount { get; private set; }

    // Number of rows that the stream has accepted.
    internal int TakenFrames => _takenFrames;

    /// <summary>
    /// Time from one frame to the next. On a seekable stream, it can be changed until the end, because a live frame time is known only then.
    /// </summary>
    /// <exception cref="ArgumentException">The value is 0.</exception>
    /// <exception cref="InvalidOperationException">The stream is not seekable, or the writer is disposed.</exception>
    public BvhFrameTime FrameTime
    {
        get => _frameTime;
        set
        {
            if (value == default)
                throw new ArgumentException("The frame time must be more than 0 s.", nameof(value));
            if (value == _frameTime)
                return;
            if (_timePlace < 0 || _isDisposed)
                throw new InvalidOperationException("The frame time is already written and cannot change.");

            _frameTime = value;
            _isTimeStale = true;
        }
    }

    // A text that is written later must fit into its place. Some programs write 17 digits.
    private string TimeText => _format.FrameTimeText is { } text && (_timePlace < 0 || text.Length <= _field.Length)
        && BvhFrameTime.TryParse(text, out BvhFrameTime time) && time == _frameTime
            ? text
            : _frameTime.ToString();

    /// <summary>Writes a row.</summary>
    /// <param name="values">As many values as the hierarchy has channels, in its order.</param>
    /// <exception cref="ArgumentException">The number of values is wrong.</exception>
    /// <exception cref="ObjectDisposedException">The writer is disposed.</exception>
    /// <exception cref="IOException">The stream fails.</exception>
    public void WriteFrame(ReadOnlySpan<float> values)
    {
        ObjectDisposedException.ThrowIf(_isDisposed, this);
        if (values.Length != Hierarchy.ChannelCount)
            throw new ArgumentException($"A row must have {Hierarchy.ChannelCount} values, not {values.Length}.", nameof(values));

        for (int i = 0; i < values.Length; i++)
        {
            if (i > 0)
                Write(_separator);

            Reserve(TextDigits.MaxSize);
            float value = values[_columns is null ? i : _columns[i]];
            _length += TextDigits.Write(_buffer.AsSpan(_length), value, Math.Min(_format.ValueDecimals, TextDigits.MaxDecimals));
        }

        Write(_rowEnd);
        _rowsEnd = _length;
        FrameCount++;
    }

    /// <summary>
    /// Passes all rows to the operating system and, on a seekable stream, updates the number of frames. These rows remain even if the process is
    /// killed.
    /// </summary>
    /// <exception cref="ObjectDisposedException">The writer is disposed.</exception>
    /// <exception cref="IOException">The stream fails.</exception>
    public void Flush()
    {
        ObjectDisposedException.ThrowIf(_isDisposed, this);
        Complete();
    }

    /// <summary>
    /// Writes the remaining rows, updates the number of frames, and closes the stream. After a failure of the stream, this truncates the file after
    /// the last complete row and closes the stream. Further calls have no effect.
    /// </summary>
    /// <exception cref="IOException">The stream fails. It is closed nevertheless.</exception>
    public void Dispose()
    {
        if (_isDisposed)
            return;

        _isDisposed = true;
        try
        {
            if (_failure is null)
                Complete();
            else
                Repair();
        }
        finally
        {
            if (!_leavesOpen)
                _stream.Dispose();
        }
    }

    // Arguments are checked before the existing file is emptied.
    private static FileStream Create(string path, BvhHierarchy hierarchy, BvhFrameTime frameTime)
    {
        Check(hierarchy, frameTime);
        return WritableFile.Create(path);
    }

    private static void Check(BvhHierarchy hierarchy, BvhFrameTime frameTime)
    {
        ArgumentNullException.ThrowIfNull(hierarchy);
        if (frameTime == default)
            throw new ArgumentException("The frame time must be more than 0 s.", nameof(frameTime));
    }

    // Readers assign columns in the order of the CHANNELS lines, which may differ from the order of the joints. Rows are written in the order of
    // the joints. Returns null if both orders are the same.
    private static int[]? FindColumns(BvhHierarchy hierarchy)
    {
        int[] columns = [.. hierarchy.Joints.SelectMany(static joint => Enumerable.Range(joint.FirstChannel, joint.Channels.Count))];
        return columns.SequenceEqual(Enumerable.Range(0, columns.Length)) ? null : columns;
    }

    private static string Decimal(int number) => number.ToString(System.Globalization.CultureInfo.InvariantCulture);

    // Readers ignore spaces after a number. Spaces before it would confuse a reader that splits at each space.
    private static string Padded(string text, int width) => text.PadRight(width);

    private void Complete()
    {
        Drain();
        if (_countPlace >= 0 && (_writtenFrameCount != FrameCount || _isTimeStale))
            Correct();

        _stream.Flush();
    }

    private void Correct()
    {
        long end = _stream.Position;
        if (_isTimeStale)
            Overwrite(_timePlace, Padded(TimeText, _field.Length));

        Overwrite(_countPlace, Padded(Decimal(FrameCount), FrameCountWidth));
        _stream.Position = end;
        _writtenFrameCount = FrameCount;
        _isTimeStale = false;
    }

    private void Overwrite(long place, string text)
    {
        _stream.Position = place;
        _stream.Write(_field, 0, Encoding.ASCII.GetBytes(text, 0, text.Length, _field, 0));
    }

    private void WriteText(string text)
    {
        byte[] bytes = Encoding.UTF8.GetBytes(text);
        for (int start = 0; start < bytes.Length; start += BufferSize / 2)
            Write(bytes.AsSpan(start, Math.Min(BufferSize / 2, bytes.Length - start)));
    }

    private void Write(ReadOnlySpan<byte> bytes)
    {
        Reserve(bytes.Length);
        bytes.CopyTo(_buffer.AsSpan(_length));
        _length += bytes.Length;
    }

    private void Reserve(int count)
    {
        if (_buffer.Length - _length < count)
            Drain();
    }

    private void Drain()
    {
        if (_failure is not null)
            throw new IOException(_failure.Message, _failure);

        try
        {
            _stream.Write(_buffer, 0, _length);
        }
        catch (Exception exception)
        {
            _failure = exception;
            FrameCount = _takenFrames;
            Repair();
            throw;
        }

        if (_rowsEnd >= 0)
        {
            _takenEnd += _rowsEnd + _carried;
            _takenFrames = FrameCount;
            _carried = 0;
        }

        _carried += _length - Math.Max(_rowsEnd, 0);
        _rowsEnd = -1;
        _length = 0;
    }

    // Truncates the file after the last whole row. A full disk still allows shortening the file and replacing bytes. The caller receives the
    // original failure.
    private void Repair()
    {
        if (!_stream.CanSeek)
            return;

        try
        {
            _stream.SetLength(_takenEnd);
            _stream.Position = _takenEnd;
            if (_countPlace >= 0 && _takenEnd > _start)
                Correct();

            _stream.Flush();
        }
        catch (Exception exception) when (exception is IOException or NotSupportedException or ObjectDisposedException)
        {
        }
    }
}
