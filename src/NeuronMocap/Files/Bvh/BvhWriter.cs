using System.Text;
using NeuronMocap.Files;
using NeuronMocap.Protocol;

namespace NeuronMocap.Bvh;

/// <summary>
/// Writes a BVH file row by row, in constant memory. Values have as many decimals as the <see cref="BvhTextFormat"/> says, or more where it takes
/// these to be read back as the same binary32; NaN and infinities are written as <c>NaN</c>, <c>Infinity</c> and <c>-Infinity</c>. A row allocates nothing. For one
/// thread.
/// <para>
/// The number of frames is not known before the end. Where the stream can seek, the fields of the number and of the frame time have a fixed width
/// and are written again with every <see cref="Flush"/> and at the end, after the rows that they count: a file that is cut off at any moment opens, with all rows
/// up to the last flush. When the stream takes no more, because the disk is full for example, the file is cut behind the last row that it took whole, and
/// <see cref="FrameCount"/> is what it holds. Where the stream cannot seek, the file says <c>Frames: 0</c>, which <see cref="BvhDocument"/> reads as what is there, and other programs may not.
/// </para>
/// </summary>
public sealed class BvhWriter : IDisposable
{
    // Wide enough for any number of frames, and for any frame time of fifteen decimals.
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
    private readonly byte[] _field = new byte[FrameTimeWidth];
    private readonly long _countPlace = -1;
    private readonly long _timePlace = -1;
    private readonly long _start;
    private int _length;
    private int _writtenFrameCount;

    // In the buffer, behind the last whole row or the header; and the same of what the stream has taken, with the number of rows up to there.
    private int _rowsEnd = -1;
    private long _takenEnd;
    private int _takenFrames;
    // Bytes behind that place that the stream has taken: the beginning of a row.
    private long _carried;
    private Exception? _failure;
    private BvhFrameTime _frameTime;
    private bool _isTimeStale;
    private bool _isDisposed;

    /// <summary>Opens a file and writes its hierarchy.</summary>
    /// <param name="path">Where; a file that is there already is replaced.</param>
    /// <param name="hierarchy">The joints.</param>
    /// <param name="frameTime">Time from one frame to the next, above 0.</param>
    /// <param name="format">How the text is laid out; null for <see cref="BvhTextFormat.AxisNeuron"/>.</param>
    /// <exception cref="ArgumentException">The time is none.</exception>
    /// <exception cref="IOException">The file cannot be written.</exception>
    /// <exception cref="UnauthorizedAccessException">This user may not write it.</exception>
    public BvhWriter(string path, BvhHierarchy hierarchy, BvhFrameTime frameTime, BvhTextFormat? format = null)
        : this(Create(path, hierarchy, frameTime), hierarchy, frameTime, format)
    {
    }

    /// <summary>Writes a hierarchy to a stream.</summary>
    /// <param name="stream">Where, from its position on.</param>
    /// <param name="hierarchy">The joints.</param>
    /// <param name="frameTime">Time from one frame to the next, above 0.</param>
    /// <param name="format">How the text is laid out; null for <see cref="BvhTextFormat.AxisNeuron"/>.</param>
    /// <param name="leaveOpen">Whether the stream stays open at the end.</param>
    /// <exception cref="ArgumentException">The time is none, or the stream cannot be written.</exception>
    /// <exception cref="IOException">The stream cannot be written.</exception>
    public BvhWriter(Stream stream, BvhHierarchy hierarchy, BvhFrameTime frameTime, BvhTextFormat? format = null, bool leaveOpen = false)
        : this(stream, hierarchy, frameTime, format, leaveOpen, frameCount: null)
    {
    }

    internal BvhWriter(
        Stream stream, BvhHierarchy hierarchy, BvhFrameTime frameTime, BvhTextFormat? format, bool leaveOpen, int? frameCount)
    {
        ArgumentNullException.ThrowIfNull(stream);
        if (!stream.CanWrite)
            throw new ArgumentException("The stream cannot be written.", nameof(stream));

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
        if (isPatched)
            _timePlace = stream.Position + _length;

        WriteText(Padded(TimeText, isPatched ? FrameTimeWidth : 0) + _format.LineEnd);
        _rowsEnd = _length;
    }

    /// <summary>The joints.</summary>
    public BvhHierarchy Hierarchy { get; }

    /// <summary>Number of rows that were written; once the stream has failed, of those that it holds.</summary>
    public int FrameCount { get; private set; }

    // Of them those that the stream has taken.
    internal int TakenFrames => _takenFrames;

    /// <summary>Time from one frame to the next. Where the stream can seek it can be changed until the end: live, it is known only then.</summary>
    /// <exception cref="ArgumentException">The time is none.</exception>
    /// <exception cref="InvalidOperationException">The stream cannot seek, or the writer is at its end.</exception>
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
                throw new InvalidOperationException("The frame time is written already and cannot change.");

            _frameTime = value;
            _isTimeStale = true;
        }
    }

    private string TimeText =>
        _format.FrameTimeText is { } text && BvhFrameTime.TryParse(text, out BvhFrameTime time) && time == _frameTime ? text : _frameTime.ToString();

    /// <summary>Writes a row.</summary>
    /// <param name="values">As many values as the hierarchy has channels, in its order.</param>
    /// <exception cref="ArgumentException">There are more or fewer values.</exception>
    /// <exception cref="ObjectDisposedException">The writer is at its end.</exception>
    /// <exception cref="IOException">The stream cannot be written.</exception>
    public void WriteFrame(ReadOnlySpan<float> values)
    {
        ObjectDisposedException.ThrowIf(_isDisposed, this);
        if (values.Length != Hierarchy.ChannelCount)
            throw new ArgumentException($"A row has {Hierarchy.ChannelCount} values, not {values.Length}.", nameof(values));

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
    /// Hands all rows to the system and, where the stream can seek, says how many there are: from then on they are there even when the process is killed.
    /// </summary>
    /// <exception cref="ObjectDisposedException">The writer is at its end.</exception>
    /// <exception cref="IOException">The stream cannot be written.</exception>
    public void Flush()
    {
        ObjectDisposedException.ThrowIf(_isDisposed, this);
        Complete();
    }

    /// <summary>Writes what is left, corrects the number of frames, and closes the stream. Again, or after the stream has failed: only closes it.</summary>
    /// <exception cref="IOException">The stream cannot be written; it is closed all the same.</exception>
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

    // What is wrong shows before the file is emptied that it would replace.
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

    // A reader of any file takes the columns in the order of the CHANNELS lines, which may differ from that of the joints: written they stand in
    // the order of the joints. Null where it is the same.
    private static int[]? FindColumns(BvhHierarchy hierarchy)
    {
        int[] columns = [.. hierarchy.Joints.SelectMany(static joint => Enumerable.Range(joint.FirstChannel, joint.Channels.Count))];
        return columns.SequenceEqual(Enumerable.Range(0, columns.Length)) ? null : columns;
    }

    private static string Decimal(int number) => number.ToString(System.Globalization.CultureInfo.InvariantCulture);

    // Spaces after a number are what no reader minds: those in front of it would shift the words of one that splits at each space.
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
            Overwrite(_timePlace, Padded(TimeText, FrameTimeWidth));

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

    // Ends the file behind the last whole row: a full disk still lets it become shorter, and bytes be replaced. The failure itself is what the caller
    // hears of.
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
