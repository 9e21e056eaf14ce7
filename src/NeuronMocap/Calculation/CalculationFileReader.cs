using System.Text;
using NeuronMocap.Frames;

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
    private readonly CalculationLines _lines;
    private readonly CalculationRepairLog _repairs;
    private readonly float[] _values = new float[CalculationFrame.FullValueCount];
    private readonly byte[] _rowEnd;
    private readonly int _leastDecimals;
    private bool _isFirst = true;

    /// <summary>Opens a file, and reads it up to its first row.</summary>
    /// <param name="stream">The file from its start; closed with the reader.</param>
    /// <param name="options">How to read it; null is the same as the defaults.</param>
    /// <exception cref="CalculationFormatException">There is no row of 946 or 338 numbers.</exception>
    /// <exception cref="IOException">The file cannot be read.</exception>
    public CalculationFileReader(Stream stream, CalculationReadOptions? options = null)
    {
        ArgumentNullException.ThrowIfNull(stream);
        Options = options ?? CalculationReadOptions.Default;
        _stream = stream;
        _lines = new CalculationLines(stream);
        _repairs = new CalculationRepairLog(Options.Strict);
        byte[] header = ReadHeader();
        CalculationRow row = CalculationRow.Read(_lines.Text, _values);
        ValueCount = row.Count;
        _leastDecimals = CalculationRow.FindLeastDecimals(_lines.Text);
        TextFormat = DescribeText(header, row);
        _rowEnd = Encoding.ASCII.GetBytes(TextFormat.RowEnd);
    }

    /// <summary>Values in each row: 946 for 59 bones, or 338 for 21.</summary>
    public int ValueCount { get; }

    /// <summary>Frames per second, as the options say: no export does.</summary>
    public double FrameRate => Options.FrameRate;

    /// <summary>How the text looks; the end of the last row is known when that was read.</summary>
    public CalculationTextFormat TextFormat { get; private set; }

    /// <summary>Number of rows read so far.</summary>
    public int FrameCount { get; private set; }

    /// <summary>Number of bytes read so far: how far the work has come, of <see cref="Length"/>.</summary>
    public long Position => _lines.Position;

    /// <summary>Number of bytes of the file; null when the stream cannot tell.</summary>
    public long? Length => _stream.CanSeek ? _stream.Length : null;

    /// <summary>What was wrong so far and how it was read all the same; the first hundred.</summary>
    public IReadOnlyList<CalculationRepair> Repairs => _repairs.Listed;

    /// <summary>Number of repairs so far, those included that <see cref="Repairs"/> does not list.</summary>
    public int RepairCount => _repairs.Count;

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
        var file = new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.ReadWrite, bufferSize: 1);
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
    public bool TryRead(Span<float> values)
    {
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

    /// <summary>Closes the file.</summary>
    public void Dispose() => _stream.Dispose();

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
            "This is no calculation export: there is no line of 946 numbers, or of 338.", Math.Max(_lines.Number, 1), 1);
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
            _repairs.Add(_lines.Number, row.Column, "The file ends within a number.", "The row is left out.");
            return false;
        }

        if (row.Count > ValueCount)
            _repairs.Add(_lines.Number, 1, $"A row has {row.Count} values instead of {ValueCount}.", $"The first {ValueCount} are read.");
        if (row.NotFiniteColumn > 0)
            _repairs.Add(_lines.Number, row.NotFiniteColumn, "A value is not finite.", "It is read as it stands.");

        NoteEnd(_lines.TextAndEnd[row.Length..]);
        return true;
    }

    // A row may well be the last one and lack its end; then its last number has as many digits as each in the first row. The row of 338 ends with
    // a flag, which has none.
    private bool IsCutInNumber(in CalculationRow row) =>
        FrameCount > 0 && ValueCount == CalculationFrame.FullValueCount && row.Length == _lines.TextAndEnd.Length
        && CalculationRow.CountDecimals(row.LastWord) < _leastDecimals;

    private void AddWrongRow(in CalculationRow row, string expected)
    {
        if (!row.WrongWord.IsEmpty)
            _repairs.Add(_lines.Number, row.Column, $"{Quote(row.WrongWord)} is not a number.", "The line is left out.");
        else if (!_lines.HasEnd)
            _repairs.Add(_lines.Number, row.Column, $"The file ends after {row.Count} values of a row.", "The row is left out.");
        else
            _repairs.Add(_lines.Number, 1, $"A row has {row.Count} values instead of {expected}.", "It is left out.");
    }

    private void NoteEnd(ReadOnlySpan<byte> end)
    {
        if (!end.SequenceEqual(_rowEnd))
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
            Separator = Encoding.ASCII.GetString(line.Slice(end, CountSpace(line[end..]))),
            Decimals = Math.Min(CalculationRow.CountDecimals(line[start..end]), CalculationTextFormat.MaxDecimals),
        };
        return _lines.HasEnd ? format with { RowEnd = Encoding.ASCII.GetString(_lines.TextAndEnd[row.Length..]) } : format;
    }

    private static int CountSpace(ReadOnlySpan<byte> text)
    {
        int count = 0;
        while (count < text.Length && CalculationRow.IsSpace(text[count]))
            count++;

        return count;
    }
}
