using System.Numerics;
using System.Text;

namespace NeuronMocap.Calculation;

/// <summary>
/// Reads a calculation export row by row, whatever its length, in constant memory. What is read, and what is repaired, is the same as with
/// <see cref="CalculationDocument"/>. For one thread at a time.
/// </summary>
public sealed class CalculationFileReader : IDisposable
{
    private const int LongestHeader = 1 << 20;

    // What stands above the rows of an export may have a line of numbers, too, but a row that was cut has more.
    private const int LongestHeaderNumbers = 16;
    private const int LongestQuote = 40;

    private readonly Stream _stream;
    private readonly bool _leavesOpen;
    private readonly CalculationLines _lines;
    private readonly CalculationRepairLog _repairs;
    private readonly float[] _values = new float[CalculationFrame.FullValueCount];
    private readonly byte[] _rowEnd;
    private readonly int _minDecimals;
    private bool _isFirst = true;
    private bool _isDisposed;

    /// <summary>Opens a file, and reads it up to its first row.</summary>
    /// <param name="stream">Where the text comes from. Read from where it stands; it need not seek.</param>
    /// <param name="options">How to read it; null is the same as the defaults.</param>
    /// <param name="leaveOpen">Whether the stream stays open when the reader is disposed; where this constructor throws, it does.</param>
    /// <exception cref="CalculationFormatException">There is no row of 946 or 338 numbers.</exception>
    /// <exception cref="IOException">The file cannot be read.</exception>
    public CalculationFileReader(Stream stream, CalculationReadOptions? options = null, bool leaveOpen = false)
    {
        ArgumentNullException.ThrowIfNull(stream);
        Options = options?.Copy() ?? new CalculationReadOptions();
        _stream = stream;
        _leavesOpen = leaveOpen;
        Length = stream.CanSeek ? Math.Max(0, stream.Length - stream.Position) : null;
        _lines = new CalculationLines(stream, Options.Progress);
        _repairs = new CalculationRepairLog(Options.Strict);
        byte[] header = ReadHeader();
        CalculationRow row = CalculationRow.Read(_lines.Text, _values);
        ValueCount = row.Count;
        DeclaredFrameRate = CalculationHeaderText.ReadFrameRate(header);
        InitialDirection = CalculationHeaderText.ReadDirection(header);
        _minDecimals = CalculationRow.FindLeastDecimals(_lines.Text);
        TextFormat = DescribeText(header, row);
        _rowEnd = Encoding.ASCII.GetBytes(TextFormat.RowEnd);
    }

    /// <summary>Values in each row: 946 for 59 bones, or 338 for 21.</summary>
    public int ValueCount { get; }

    /// <summary>Frames per second: the options' rate, or <see cref="DeclaredFrameRate"/>, or 120.</summary>
    public double FrameRate => Options.FrameRate ?? DeclaredFrameRate ?? CalculationReadOptions.DefaultFrameRate;

    /// <summary>Frames per second as the file's header says; null where it does not. Axis Neuron's exports do not, this library's do.</summary>
    public double? DeclaredFrameRate { get; }

    /// <summary>
    /// The direction that the actor faces at the start, in the file's axes: the line <c>Zd:</c> of the header. Null where there is none.
    /// </summary>
    public Vector3? InitialDirection { get; }

    /// <summary>How the text looks; the end of the last row is known when that was read.</summary>
    public CalculationTextFormat TextFormat { get; private set; }

    /// <summary>Number of rows read so far.</summary>
    public long FrameCount { get; private set; }

    /// <summary>Number of bytes of the lines read so far: how far the work has come, of <see cref="Length"/>.</summary>
    public long BytesRead => _lines.BytesRead;

    /// <summary>Bytes that the stream had to offer at the start; null when it does not know.</summary>
    public long? Length { get; }

    /// <summary>What was wrong so far and how it was read all the same; the first hundred.</summary>
    public IReadOnlyList<CalculationRepair> Repairs => _repairs.Listed;

    /// <summary>Number of repairs so far, those included that <see cref="Repairs"/> does not list.</summary>
    public int RepairCount => _repairs.Count;

    /// <summary>Number of lines so far that are no row and were left out.</summary>
    public int SkippedRowCount => _repairs.LeftOutCount;

    internal CalculationReadOptions Options { get; }

    /// <summary>Opens a file, and reads it up to its first row.</summary>
    /// <param name="path">Where it is.</param>
    /// <param name="options">How to read it; null is the same as the defaults.</param>
    /// <returns>A reader, to be disposed.</returns>
    /// <exception cref="CalculationFormatException">There is no row of 946 or 338 numbers.</exception>
    /// <exception cref="IOException">The file is not there or cannot be read.</exception>
    /// <exception cref="UnauthorizedAccessException">This user may not read it.</exception>
    public static CalculationFileReader Open(string path, CalculationReadOptions? options = null)
    {
        FileStream file = OpenFile(path);
        try
        {
            return new CalculationFileReader(file, options);
        }
        catch
        {
            file.Dispose();
            throw;
        }
    }

    /// <summary>Reads the next row.</summary>
    /// <param name="values">
    /// Receives <see cref="ValueCount"/> values, in the order of the calculation stream, each the binary32 nearest to its text; undefined at the end.
    /// </param>
    /// <returns>False at the end of the file.</returns>
    /// <exception cref="ArgumentException">There is less room.</exception>
    /// <exception cref="CalculationFormatException">The options demand strict reading, and something is wrong.</exception>
    /// <exception cref="IOException">The file cannot be read.</exception>
    /// <exception cref="ObjectDisposedException">The reader is disposed.</exception>
    public bool TryReadFrame(Span<float> values)
    {
        ObjectDisposedException.ThrowIf(_isDisposed, this);
        if (values.Length < ValueCount)
            throw new ArgumentException($"A row has {ValueCount} values.", nameof(values));

        while (_isFirst || _lines.TryRead())
        {
            _isFirst = false;
            if (TryReadRow(values[..ValueCount]))
            {
                FrameCount++;
                return true;
            }
        }

        return false;
    }

    /// <summary>Closes the stream, unless it is to stay open.</summary>
    public void Dispose()
    {
        _isDisposed = true;
        if (!_leavesOpen)
            _stream.Dispose();
    }

    // Not buffered a second time.
    internal static FileStream OpenFile(string path) =>
        new(path, FileMode.Open, FileAccess.Read, FileShare.ReadWrite | FileShare.Delete, bufferSize: 1, FileOptions.SequentialScan);

    private static bool IsRow(in CalculationRow row) =>
        row.WrongWord.IsEmpty && row.Count is CalculationFrame.FullValueCount or CalculationFrame.BodyValueCount;

    private static string Quote(ReadOnlySpan<byte> text)
    {
        string start = Encoding.UTF8.GetString(text[..Math.Min(text.Length, LongestQuote)]);
        char[] letters = Array.ConvertAll(start.ToCharArray(), static letter => char.IsControl(letter) ? '?' : letter);
        return $"'{new string(letters)}{(text.Length > LongestQuote ? "..." : "")}'";
    }

    // Everything above the first whole row, save for rows that are not whole.
    private byte[] ReadHeader()
    {
        using var header = new MemoryStream();
        while (_lines.TryRead())
        {
            CalculationRow row = CalculationRow.Read(_lines.Text, _values);
            if (IsRow(row))
                return header.ToArray();

            if (row.Count > LongestHeaderNumbers)
                AddWrongRow(row, "946 or 338");
            else
                header.Write(_lines.TextAndEnd);
            if (header.Length > LongestHeader)
                break;
        }

        throw new CalculationFormatException(
            "This is not a calculation export: it has no line of 946 or 338 numbers.", Math.Max(_lines.Number, 1), 1);
    }

    private bool TryReadRow(Span<float> values)
    {
        CalculationRow row = CalculationRow.Read(_lines.Text, values);
        if (row.Count == 0 && row.WrongWord.IsEmpty)
            return false;

        if (!row.WrongWord.IsEmpty || row.Count < ValueCount)
        {
            AddWrongRow(row, ValueCount.ToString(System.Globalization.CultureInfo.InvariantCulture));
            return false;
        }

        if (IsCutInNumber(row))
        {
            _repairs.Add(_lines.Number, row.Column, "The file ends within a number", "the row is skipped", isLeftOut: true);
            return false;
        }

        if (row.Count > ValueCount)
            _repairs.Add(_lines.Number, 1, $"A row has {row.Count} values instead of {ValueCount}", $"the first {ValueCount} are read");
        if (row.NotFiniteColumn > 0)
            _repairs.Add(_lines.Number, row.NotFiniteColumn, "A value is not finite", "it is kept");

        NoteEnd(_lines.TextAndEnd[row.Length..]);
        return true;
    }

    // A row may well be the last one and lack its end; then its last number has as many digits as each in the first row. The row of 338 ends with
    // a flag, which has none.
    private bool IsCutInNumber(in CalculationRow row) =>
        FrameCount > 0 && ValueCount == CalculationFrame.FullValueCount && row.Length == _lines.TextAndEnd.Length
        && CalculationRow.CountDecimals(row.LastWord) < _minDecimals;

    private void AddWrongRow(in CalculationRow row, string expected)
    {
        if (!row.WrongWord.IsEmpty)
            _repairs.Add(_lines.Number, row.Column, $"{Quote(row.WrongWord)} is not a number", "the line is skipped", isLeftOut: true);
        else if (!_lines.HasEnd)
            _repairs.Add(_lines.Number, row.Column, $"The file ends after {row.Count} values of a row", "the row is skipped", isLeftOut: true);
        else
            _repairs.Add(_lines.Number, 1, $"A row has {row.Count} values instead of {expected}", "it is skipped", isLeftOut: true);
    }

    private void NoteEnd(ReadOnlySpan<byte> end)
    {
        if (!end.SequenceEqual(_rowEnd) && end.Length <= CalculationTextFormat.LongestSpace)
            TextFormat = TextFormat with { LastRowEnd = Encoding.ASCII.GetString(end) };
        else if (TextFormat.LastRowEnd is not null)
            TextFormat = TextFormat with { LastRowEnd = null };
    }

    private CalculationTextFormat DescribeText(byte[] header, in CalculationRow row)
    {
        ReadOnlySpan<byte> line = _lines.Text;
        int start = CountSpace(line);
        int end = start;
        while (!CalculationRow.IsSpace(line[end]))
            end++;

        var format = CalculationTextFormat.AxisNeuron with
        {
            Header = header,
            Decimals = Math.Min(CalculationRow.CountDecimals(line[start..end]), CalculationTextFormat.MaxDecimals),
        };

        // What is longer than any program writes is no layout to keep.
        ReadOnlySpan<byte> separator = line.Slice(end, CountSpace(line[end..]));
        ReadOnlySpan<byte> rowEnd = _lines.TextAndEnd[row.Length..];
        if (separator.Length <= CalculationTextFormat.LongestSpace)
            format = format with { Separator = Encoding.ASCII.GetString(separator) };
        if (_lines.HasEnd && rowEnd.Length <= CalculationTextFormat.LongestSpace)
            format = format with { RowEnd = Encoding.ASCII.GetString(rowEnd) };

        return format;
    }

    private static int CountSpace(ReadOnlySpan<byte> text)
    {
        int count = 0;
        while (count < text.Length && CalculationRow.IsSpace(text[count]))
            count++;

        return count;
    }
}
