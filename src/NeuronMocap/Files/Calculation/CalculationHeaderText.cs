using System.Globalization;
using System.Numerics;
using System.Text;

namespace NeuronMocap.Calculation;

// Reads and writes the lines above the rows of an export. Axis Neuron writes "Zd:" with the direction that the actor faces at the start, "bones:"
// with their number, and the column names. It does not write the frame rate; this line is an addition of this library.
internal static class CalculationHeaderText
{
    private const string ByteOrderMark = "\u00EF\u00BB\u00BF"; // of UTF-8, one letter for each byte
    private const string FrameRateName = "Frame Rate:";
    private const double HighestRate = 1e6;

    public static double? ReadFrameRate(ReadOnlySpan<byte> header) =>
        Find(header, FrameRateName) is { } text
        && double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out double rate)
        && rate is > 0 and <= HighestRate
            ? rate
            : null;

    public static Vector3? ReadDirection(ReadOnlySpan<byte> header)
    {
        string[] words = Find(header, "Zd:")?.Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries) ?? [];
        Vector3 direction = default;
        if (words.Length != 3
            || !TryParse(words[0], out direction.X)
            || !TryParse(words[1], out direction.Y)
            || !TryParse(words[2], out direction.Z))
        {
            return null;
        }

        return direction;
    }

    /// <summary>Adds a line with the frame rate to a header, or replaces that line.</summary>
    public static byte[] WithFrameRate(ReadOnlySpan<byte> header, double rate)
    {
        var text = new StringBuilder();
        string all = ToText(header);
        string whole = WithoutMark(all);
        text.Append(all, 0, all.Length - whole.Length);
        string[] lines = whole.Split('\n');
        foreach (string line in lines)
        {
            if (!IsNamed(line, FrameRateName))
                text.Append(line).Append('\n');
        }

        // The text after the last line end is not a line.
        text.Length--;
        text.Append(FrameRateName).Append('\t').Append(Shortest(rate)).Append("\r\n");
        byte[] bytes = new byte[text.Length];
        for (int i = 0; i < bytes.Length; i++)
            bytes[i] = (byte)text[i];

        return bytes;
    }

    // One letter for each byte, whatever the encoding. Names and numbers are ASCII; all other bytes are only kept.
    private static string ToText(ReadOnlySpan<byte> header)
    {
        char[] letters = new char[header.Length];
        for (int i = 0; i < letters.Length; i++)
            letters[i] = (char)header[i];

        return new string(letters);
    }

    private static string? Find(ReadOnlySpan<byte> header, string name)
    {
        string? line = ToText(header).Split('\r', '\n').Select(WithoutMark).FirstOrDefault(line => IsNamed(line, name));
        return line?.Trim()[name.Length..].Trim();
    }

    private static string WithoutMark(string text) => text.StartsWith(ByteOrderMark, StringComparison.Ordinal) ? text[ByteOrderMark.Length..] : text;

    private static bool IsNamed(string line, string name) => line.TrimStart().StartsWith(name, StringComparison.OrdinalIgnoreCase);

    private static bool TryParse(string word, out float value) =>
        float.TryParse(word, NumberStyles.Float, CultureInfo.InvariantCulture, out value) && !float.IsNaN(value) && !float.IsInfinity(value);

    // Writes the fewest digits that are read as the same number again. On .NET Framework and Mono, the format "R" writes other digits, and sometimes loses
    // the last one.
    private static string Shortest(double number)
    {
        for (int digits = 15; ; digits++)
        {
            string text = number.ToString("G" + digits.ToString(CultureInfo.InvariantCulture), CultureInfo.InvariantCulture);
            if (digits == 17 || double.Parse(text, CultureInfo.InvariantCulture).Equals(number))
                return text;
        }
    }
}
