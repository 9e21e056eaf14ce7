using System.Text;
using NeuronMocap.Files;
using NeuronMocap.Protocol;

namespace NeuronMocap.Calculation;

/// <summary>
/// Writes a calculation export of any length row by row, in constant memory. Reading the file gives the same binary32 values. Not thread-safe.
/// </summary>
/// <remarks>
/// If the stream fails, for example on a full disk, the writer writes nothing more. Every later call throws an <see cref="IOException"/>, and
/// <see cref="Dispose"/> only closes the stream. The file may end within a row.
/// </remarks>
public sealed class CalculationFileWriter : IDisposable
{
    private const int FirstContact = CalculationFrame.BodyValueCount - 2;

    private readonly RowOutput _output;
    private readonly int _decimals;
    private readonly byte[] _separator;
    private readonly byte[] _rowEnd;
    private readonly byte[]? _lastRowEnd;
    private bool _isEndOpen;

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
    /// <exception cref="ArgumentException">The number of values is wrong, or the stream is not writable.</exception>
    /// <exception cref="IOException">The stream fails.</exception>
    public CalculationFileWriter(Stream stream, int valueCount, CalculationTextFormat? format = null, bool leaveOpen = false)
    {
        ArgumentNullException.ThrowIfNull(stream);
        if (!stream.CanWrite)
            throw new ArgumentException("The stream is not writable.", nameof(stream));

        Check(valueCount);
        format ??= CalculationTextFormat.AxisNeuron;
        _output = new RowOutput(stream, leaveOpen, TextDigits.MaxSize);
        _decimals = format.Decimals;
        _separator = Encoding.ASCII.GetBytes(format.Separator);
        _rowEnd = Encoding.ASCII.GetBytes(format.RowEnd);
        _lastRowEnd = format.LastRowEnd is null ? null : Encoding.ASCII.GetBytes(format.LastRowEnd);
        ValueCount = valueCount;
        _output.Write(format.Header.Span);
        _output.Flush();
    }

    /// <summary>Number of values in each row: 946 for 59 bones, or 338 for 21.</summary>
    public int ValueCount { get; }

    /// <summary>Number of rows written so far. After a failure, the stream may hold fewer.</summary>
    public long FrameCount { get; private set; }

    /// <summary>Writes a row.</summary>
    /// <param name="values">Exactly <see cref="ValueCount"/> values, in the order of the calculation stream.</param>
    /// <exception cref="ArgumentException">The number of values is wrong.</exception>
    /// <exception cref="ObjectDisposedException">The writer is disposed.</exception>
    /// <exception cref="IOException">The stream fails, or failed before.</exception>
    public void WriteFrame(ReadOnlySpan<float> values)
    {
        if (values.Length != ValueCount)
            throw new ArgumentException($"A row must have {ValueCount} values, not {values.Length}.", nameof(values));
        ObjectDisposedException.ThrowIf(_output.IsDisposed, this);

        if (_isEndOpen)
            _output.Write(_rowEnd);

        for (int i = 0; i < values.Length; i++)
        {
            if (i > 0)
                _output.Write(_separator);

            bool isContact = i is FirstContact or FirstContact + 1;
            _output.Advance(TextDigits.Write(_output.Free, values[i], isContact ? 0 : _decimals));
        }

        // The writer knows that a row is the last one only when no other row follows.
        _isEndOpen = _lastRowEnd is not null;
        if (!_isEndOpen)
            _output.Write(_rowEnd);

        FrameCount++;
    }

    /// <summary>Passes the rows written so far to the stream.</summary>
    /// <exception cref="IOException">The stream fails, or failed before.</exception>
    public void Flush() => _output.Flush();

    /// <summary>Ends the last row and closes the stream. After a failure of the stream, this only closes it.</summary>
    /// <exception cref="IOException">The stream fails. It is closed nevertheless.</exception>
    public void Dispose()
    {
        if (_output.IsDisposed)
            return;

        using (_output)
        {
            if (_isEndOpen && !_output.HasFailed)
                _output.Write(_lastRowEnd);
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
}
