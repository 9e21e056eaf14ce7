using System.Text;
using NeuronMocap.Files;
using NeuronMocap.Protocol;

namespace NeuronMocap.Calculation;

/// <summary>
/// Writes a calculation export of any length row by row, in constant memory. Reading the file gives the same binary32 values. Not thread-safe.
/// </summary>
public sealed class CalculationFileWriter : IDisposable
{
    private const int FirstContact = CalculationFrame.BodyValueCount - 2;
    private const int BufferSize = 1 << 16;

    private readonly Stream _stream;
    private readonly bool _leavesOpen;
    private readonly int _decimals;
    private readonly byte[] _separator;
    private readonly byte[] _rowEnd;
    private readonly byte[]? _lastRowEnd;
    private readonly byte[] _buffer;
    private int _length;
    private bool _isEndOpen;
    private bool _isDisposed;

    /// <summary>Creates a file and writes the header of the format. The file is complete after the writer is disposed.</summary>
    /// <param name="path">The path of the file. An existing file is replaced.</param>
    /// <param name="valueCount">Number of values in each row: 946 or 338.</param>
    /// <param name="format">The text layout; null for <see cref="CalculationTextFormat.AxisNeuron"/>.</param>
    /// <exception cref="ArgumentException">The number of values is wrong.</exception>
    /// <exception cref="IOException">The file cannot be written.</exception>
    /// <exception cref="UnauthorizedAccessException">The user does not have permission to write the file.</exception>
    public CalculationFileWriter(string path, int valueCount, CalculationTextFormat? format = null)
        : this(CreateFile(path, valueCount), valueCount, format)
    {
    }

    /// <summary>Writes the header of the format to a stream.</summary>
    /// <param name="stream">The stream to write, from its current position.</param>
    /// <param name="valueCount">Number of values in each row: 946 or 338.</param>
    /// <param name="format">The text layout; null for <see cref="CalculationTextFormat.AxisNeuron"/>.</param>
    /// <param name="leaveOpen">Whether the stream stays open when the writer is disposed.</param>
    /// <exception cref="ArgumentException">The number of values is wrong.</exception>
    /// <exception cref="IOException">The stream fails.</exception>
    public CalculationFileWriter(Stream stream, int valueCount, CalculationTextFormat? format = null, bool leaveOpen = false)
    {
        ArgumentNullException.ThrowIfNull(stream);
        Check(valueCount);
        format ??= CalculationTextFormat.AxisNeuron;
        _stream = stream;
        _leavesOpen = leaveOpen;
        _decimals = format.Decimals;
        _separator = Encoding.ASCII.GetBytes(format.Separator);
        _rowEnd = Encoding.ASCII.GetBytes(format.RowEnd);
        _lastRowEnd = format.LastRowEnd is null ? null : Encoding.ASCII.GetBytes(format.LastRowEnd);
        _buffer = new byte[BufferSize + TextDigits.MaxSize + _separator.Length];
        ValueCount = valueCount;
        _stream.Write(format.Header.Span);
    }

    /// <summary>Number of values in each row: 946 for 59 bones, or 338 for 21.</summary>
    public int ValueCount { get; }

    /// <summary>Number of rows written so far.</summary>
    public long FrameCount { get; private set; }

    /// <summary>Writes a row.</summary>
    /// <param name="values">Exactly <see cref="ValueCount"/> values, in the order of the calculation stream.</param>
    /// <exception cref="ArgumentException">The number of values is wrong.</exception>
    /// <exception cref="ObjectDisposedException">The writer is disposed.</exception>
    /// <exception cref="IOException">The stream fails.</exception>
    public void WriteFrame(ReadOnlySpan<float> values)
    {
        if (values.Length != ValueCount)
            throw new ArgumentException($"A row must have {ValueCount} values, not {values.Length}.", nameof(values));
        ObjectDisposedException.ThrowIf(_isDisposed, this);

        if (_isEndOpen)
            Write(_rowEnd);

        for (int i = 0; i < values.Length; i++)
        {
            if (i > 0)
                Write(_separator);
            if (_length >= BufferSize)
                Flush();

            bool isContact = i is FirstContact or FirstContact + 1;
            _length += TextDigits.Write(_buffer.AsSpan(_length), values[i], isContact ? 0 : _decimals);
        }

        // The writer knows that a row is the last one only when no other row follows.
        _isEndOpen = _lastRowEnd is not null;
        if (!_isEndOpen)
            Write(_rowEnd);

        FrameCount++;
    }

    /// <summary>Passes the rows written so far to the stream.</summary>
    /// <exception cref="IOException">The stream fails.</exception>
    public void Flush()
    {
        _stream.Write(_buffer, 0, _length);
        _length = 0;
    }

    /// <summary>Ends the last row and closes the stream.</summary>
    /// <exception cref="IOException">The stream fails.</exception>
    public void Dispose()
    {
        if (_isDisposed)
            return;

        _isDisposed = true;
        try
        {
            if (_isEndOpen)
                Write(_lastRowEnd);
            Flush();
        }
        finally
        {
            if (!_leavesOpen)
                _stream.Dispose();
        }
    }

    // Arguments are checked before the existing file is emptied.
    private static FileStream CreateFile(string path, int valueCount)
    {
        Check(valueCount);
        return WritableFile.Create(path);
    }

    private static void Check(int valueCount)
    {
        if (valueCount is not (CalculationFrame.FullValueCount or CalculationFrame.BodyValueCount))
            throw new ArgumentException("A row must have 946 or 338 values.", nameof(valueCount));
    }

    private void Write(ReadOnlySpan<byte> text)
    {
        if (_length + text.Length > _buffer.Length)
            Flush();
        if (text.Length > _buffer.Length)
            throw new ArgumentException("The separator is too long.", nameof(text));

        text.CopyTo(_buffer.AsSpan(_length));
        _length += text.Length;
    }
}
