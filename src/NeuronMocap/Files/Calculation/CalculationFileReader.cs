using System.Numerics;
using System.Text;
using NeuronMocap.Protocol;

namespace NeuronMocap.Calculation;

/// <summary>
/// Reads a calculation export of any length row by row, in constant memory. Values and repairs are the same as with
/// <see cref="CalculationDocument"/>. Not thread-safe.
/// </summary>
public sealed class CalculationFileReader : IDisposable
{
    private const int LongestHeader = 1 << 20;

    // The header of an export may also have lines of numbers. A truncated row has more of them.
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

    /// <summary>Reads a stream up to its first row.</summary>
    /// <param name="stream">The stream to read, from its current position. It does not have to be seekable.</param>
    /// <param name="options">The options; null for the defaults.</param>
    /// <param name="leaveOpen">
    /// Whether the stream stays open when the reader is disposed. If this constructor throws, the stream always stays open.
    /// </param>
    /// <exception cref="CalculationFormatException">The text has no row of 946 or 338 numbers.</exception>
    /// <exception cref="IOException">The stream fails.</exception>
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

    /// <summary>Number of values in each row: 946 for 59 bones, or 338 for 21.</summary>
    public int ValueCount { get; }

    /// <summary>Frames per second: the rate of the options, or <see cref="DeclaredFrameRate"/>, or 120.</summary>
    public double FrameRate => Options.FrameRate ?? DeclaredFrameRate ?? CalculationReadOptions.DefaultFrameRate;

    /// <summary>
    /// Frames per second as declared in the header; null if not declared. Exports of this library declare the rate, those of Axis Neuron do not.
    /// </summary>
    public double? DeclaredFrameRate { get; }

    /// <summary>
    /// The direction that the actor faces at the start, in the axes of the file: the line <c>Zd:</c> of the header. Null if the header does not
    /// have this line.
    /// </summary>
    public Vector3? InitialDirection { get; }

    /// <summary>The text layout. The end of the last row is known after that row is read.</summary>
    public CalculationTextFormat TextFormat { get; private set; }

    /// <summary>Number of rows read so far.</summary>
    public long FrameCount { get; private set; }

    /// <summary>Number of bytes in the lines read so far; compare with <see cref="Length"/> to show progress.</summary>
    public long BytesRead => _lines.BytesRead;

    /// <summary>Number of bytes available in the stream at the start; null when unknown.</summary>
    public long? Length { get; }

    /// <summary>The first hundred defects found so far, and how each was read.</summary>
    public IReadOnlyList<CalculationRepair> Repairs => _repairs.Listed;

    /// <summary>Number of repairs so far, including those that <see cref="Repairs"/> does not list.</summary>
    public int RepairCount => _repairs.Count;

    /// <summary>Number of lines skipped so far because they are not rows.</summary>
    public int SkippedRowCount => _repairs.LeftOutCount;

    internal CalculationReadOptions Options { get; }

    /// <summary>Opens a file and reads it up to its first row.</summary>
    /// <param name="path">The path of the file.</param>
    /// <param name="options">The options; null for the defaults.</param>
    /// <returns>The reader, which keeps the file open until it is disposed.</returns>
    /// <exception cref="CalculationFormatException">The file has no row of 946 or 338 numbers.</exception>
    /// <exception cref="IOException">The file does not exist or cannot be read.</exception>
    /// <exception cref="UnauthorizedAccessException">The user does not have permission to read the file.</exception>
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
    /// Receives <see cref="ValueCount"/> values, in the order of the calculation stream. Each is the binary32 number nearest to its text. At the
    /// end, the content is undefined.
    /// </param>
    /// <returns>True if a row was read; false at the end.</returns>
    /// <exception cref="ArgumentException">The span is too short.</exception>
    /// <exception cref="CalculationFormatException">With <see cref="CalculationReadOptions.Strict"/>: the text has a defect.</exception>
    /// <exception cref="IOException">The stream fails.</exception>
    /// <exception cref="ObjectDisposedException">The reader is disposed.</exception>
    public bool TryReadFrame(Span<float> values)
    {
        ObjectDisposedException.ThrowIf(_isDisposed, this);
        if (values.Length < ValueCount)
            throw new ArgumentException($"There must be room for the row's {ValueCount} values.", nameof(values));

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

    /// <summary>Closes the stream, unless the reader was created with leaveOpen.</summary>
    public void Dispose()
    {
        _isDisposed = true;
        if (!_leavesOpen)
            _stream.Dispose();
    }

    // Without a second buffer.
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

    // Reads everything above the first whole row, except for incomplete rows.
    private byte[] ReadHeader()
    {
        using var header = new MemoryStream();
        while (_lines.TryRead())
        {
            // An editor may have put it before the first line.
            if (_lines.Number == 1)
                header.Write(_lines.TakeByteOrderMark());

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
            _repairs.Add(_lines.Number, 1, $"A row has {row.Count} {CountedNoun.Word(row.Count, "value", "values")} instead of {ValueCount}", $"the first {ValueCount} are read");
        if (row.NotFiniteColumn > 0)
            _repairs.Add(_lines.Number, row.NotFiniteColumn, "A value is not finite", "it is kept");

        NoteEnd(_lines.TextAndEnd[row.Length..]);
        return true;
    }

    // The last row of a file may be complete and only lack its line end. Its last number then has at least as many decimals as the number with the
    // fewest in the first row. A row of 338 values ends with a flag, which has no decimals.
    private bool IsCutInNumber(in CalculationRow row) =>
        FrameCount > 0 && ValueCount == CalculationFrame.FullValueCount && row.Length == _lines.TextAndEnd.Length
        && CalculationRow.CountDecimals(row.LastWord) < _minDecimals;

    private void AddWrongRow(in CalculationRow row, string expected)
    {
        if (!row.WrongWord.IsEmpty)
            _repairs.Add(_lines.Number, row.Column, $"{Quote(row.WrongWord)} is not a number", "the line is skipped", isLeftOut: true);
        else if (!_lines.HasEnd)
            _repairs.Add(_lines.Number, row.Column, $"The file ends after {row.Count} {CountedNoun.Word(row.Count, "value", "values")} of a row", "the row is skipped", isLeftOut: true);
        else
            _repairs.Add(_lines.Number, 1, $"A row has {row.Count} {CountedNoun.Word(row.Count, "value", "values")} instead of {expected}", "it is skipped", isLeftOut: true);
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

        // White space that is longer than any program writes is not kept as a layout.
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
