using NeuronMocap.Protocol;

namespace NeuronMocap.Calculation;

// The result of one pass over a line: the number of words, the first word that is not a number, and the layout of the text.
internal ref struct CalculationRow
{
    private const int FirstContact = CalculationFrame.BodyValueCount - 2;

    private ReadOnlySpan<byte> _rest;

    /// <summary>Number of numbers, up to the first word that is not a number.</summary>
    public int Count { get; private set; }

    /// <summary>The first word that is not a number; empty when all are numbers.</summary>
    public ReadOnlySpan<byte> WrongWord { get; private set; }

    /// <summary>Column of the last word read, from 1.</summary>
    public int Column { get; private set; }

    /// <summary>The last word that is a number.</summary>
    public ReadOnlySpan<byte> LastWord { get; private set; }

    /// <summary>Column of the first value that is not finite; 0 when all are finite.</summary>
    public int NotFiniteColumn { get; private set; }

    /// <summary>Number of bytes of the line up to the end of the last number.</summary>
    public int Length { get; private set; }

    /// <summary>Reads numbers into a row. Numbers that do not fit are only counted.</summary>
    public static CalculationRow Read(ReadOnlySpan<byte> line, Span<float> values)
    {
        var row = new CalculationRow { _rest = line };
        while (row.TryReadWord(line.Length, out ReadOnlySpan<byte> word))
        {
            if (!TextNumber.TryParse(word, out float value))
            {
                row.WrongWord = word;
                break;
            }

            if (row.Count < values.Length)
                values[row.Count] = value;
            if (row.NotFiniteColumn == 0 && !float.IsFinite(value))
                row.NotFiniteColumn = row.Column;

            row.Count++;
            row.LastWord = word;
            row.Length = line.Length - row._rest.Length;
        }

        return row;
    }

    /// <summary>Counts the digits after the decimal point of a number.</summary>
    public static int CountDecimals(ReadOnlySpan<byte> word)
    {
        int point = word.IndexOf((byte)'.');
        int count = 0;
        while (point >= 0 && point + 1 + count < word.Length && word[point + 1 + count] is >= (byte)'0' and <= (byte)'9')
            count++;

        return count;
    }

    /// <summary>Finds the smallest number of decimals in a row, ignoring the contact flags.</summary>
    public static int FindLeastDecimals(ReadOnlySpan<byte> line)
    {
        var row = new CalculationRow { _rest = line };
        int least = int.MaxValue;
        for (int column = 0; row.TryReadWord(line.Length, out ReadOnlySpan<byte> word); column++)
        {
            if (column is not (FirstContact or FirstContact + 1))
                least = Math.Min(least, CountDecimals(word));
        }

        return least;
    }

    public static bool IsSpace(byte letter) => letter == ' ' || (letter >= '\t' && letter <= '\r');

    private bool TryReadWord(int lineLength, out ReadOnlySpan<byte> word)
    {
        int start = 0;
        while (start < _rest.Length && IsSpace(_rest[start]))
            start++;

        int end = start;
        while (end < _rest.Length && !IsSpace(_rest[end]))
            end++;

        Column = lineLength - _rest.Length + start + 1;
        word = _rest[start..end];
        _rest = _rest[end..];
        return !word.IsEmpty;
    }
}
