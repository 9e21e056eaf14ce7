using System.Text;
using NeuronMocap.Files;
using NeuronMocap.Protocol;

namespace NeuronMocap.Calculation;

/// <summary>
/// Writes a calculation export row by row, whatever its length, in constant memory. What is written is read back as the same binary32 values. For
/// one thread at a time.
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

    /// <summary>Begins a file: writes the format's header. Only when it is disposed of is the file whole.</summary>
    /// <param name="path">Where; a file that is there already is replaced.</param>
    /// <param name="valueCount">Values of each row: 946, or 338.</param>
    /// <param name="format">How the text shall look; null is the same as <see cref="CalculationTextFormat.AxisNeuron"/>.</param>
    /// <exception cref="ArgumentException">There is no such number of values.</exception>
    /// <exception cref="IOException">The file cannot be written.</exception>
    /// <exception cref="UnauthorizedAccessException">This user may not write it.</exception>
    public CalculationFileWriter(string path, int valueCount, CalculationTextFormat? format = null)
        : this(CreateFile(path, valueCount), valueCount, format)
    {
    }

    /// <summary>Begins a file on a stream: writes the format's header.</summary>
    /// <param name="stream">Where to, from the current place on.</param>
    /// <param name="valueCount">Values of each row: 946, or 338.</param>
    /// <param name="format">How the text shall look; null is the same as <see cref="CalculationTextFormat.AxisNeuron"/>.</param>
    /// <param name="leaveOpen">Whether the stream stays open when the writer is disposed.</param>
    /// <exception cref="ArgumentException">There is no such number of values.</exception>
    /// <exception cref="IOException">The header cannot be written.</exception>
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

    /// <summary>Values in each row: 946 for 59 bones, or 338 for 21.</summary>
    public int ValueCount { get; }

    /// <summary>Number of rows written so far.</summary>
    public long FrameCount { get; private set; }

    /// <summary>Writes a row.</summary>
    /// <param name="values">Exactly <see cref="ValueCount"/> values, in the order of the calculation stream.</param>
    /// <exception cref="ArgumentException">There is another number of them.</exception>
    /// <exception cref="ObjectDisposedException">The file is closed.</exception>
    /// <exception cref="IOException">The file cannot be written.</exception>
    public void WriteFrame(ReadOnlySpan<float> values)
    {
        if (values.Length != ValueCount)
            throw new ArgumentException($"A row has {ValueCount} values.", nameof(values));
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

        // Whether it is the last row shows only when no other one follows.
        _isEndOpen = _lastRowEnd is not null;
        if (!_isEndOpen)
            Write(_rowEnd);

        FrameCount++;
    }

    /// <summary>Hands what was written so far to the stream.</summary>
    /// <exception cref="IOException">The file cannot be written.</exception>
    public void Flush()
    {
        _stream.Write(_buffer, 0, _length);
        _length = 0;
    }

    /// <summary>Ends the last row and closes the file.</summary>
    /// <exception cref="IOException">The file cannot be written.</exception>
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

    // What is wrong shows before the file is emptied that it would replace.
    private static FileStream CreateFile(string path, int valueCount)
    {
        Check(valueCount);
        return WritableFile.Create(path);
    }

    private static void Check(int valueCount)
    {
        if (valueCount is not (CalculationFrame.FullValueCount or CalculationFrame.BodyValueCount))
            throw new ArgumentException("A row has 946 values or 338.", nameof(valueCount));
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
