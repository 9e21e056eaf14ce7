using NeuronMocap.Protocol;

namespace NeuronMocap.Calculation;

// What one pass over a line found: how many words, which of them is no number, and how the text looks.
internal ref struct CalculationRow
{
    private const int FirstContact = CalculationFrame.BodyValueCount - 2;

    private ReadOnlySpan<byte> _rest;

    /// <summary>Number of words that are numbers, up to the first one that is none.</summary>
    public int Count { get; private set; }

    /// <summary>The first word that is no number; empty when all are.</summary>
    public ReadOnlySpan<byte> WrongWord { get; private set; }

    /// <summary>Column of the word that was read last, from 1.</summary>
    public int Column { get; private set; }

    /// <summary>The last word that is a number.</summary>
    public ReadOnlySpan<byte> LastWord { get; private set; }

    /// <summary>Column of the first value that is not finite; 0 when all are.</summary>
    public int NotFiniteColumn { get; private set; }

    /// <summary>Bytes of the line up to the end of the last number.</summary>
    public int Length { get; private set; }

    /// <summary>Reads numbers into a row; those that it has no room for are counted only.</summary>
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

    /// <summary>Digits after the point of a number's text.</summary>
    public static int CountDecimals(ReadOnlySpan<byte> word)
    {
        int point = word.IndexOf((byte)'.');
        int count = 0;
        while (point >= 0 && point + 1 + count < word.Length && word[point + 1 + count] is >= (byte)'0' and <= (byte)'9')
            count++;

        return count;
    }

    /// <summary>Digits after the point that every number of a row has, its contact flags aside.</summary>
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
