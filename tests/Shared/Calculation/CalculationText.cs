using System.Globalization;
using System.Text;

namespace NeuronMocap.Tests.Calculation;

// Rows of text of a calculation export.
internal static class CalculationText
{
    public static readonly string[] Takes = ["MasterLiuPerformanceChar00.calc", "hiphop_up_Char00.calc", "salsa_left_Char00.calc"];

    // All values differ, except the contact flags.
    public static float Value(int row, int column) =>
        column is 336 or 337 ? (row + column) % 2 : MathF.Round((((row * 7919) + (column * 104_729)) % 100_003) / 10_000f, 4) * (column % 3 == 0 ? -1 : 1);

    public static string Row(int row, int columns = 946, string separator = "\t") =>
        string.Join(separator, Enumerable.Range(0, columns).Select(column => Word(Value(row, column), column)));

    public static string Rows(int count, int columns = 946, string separator = "\t", string end = "\t\r\n") =>
        string.Concat(Enumerable.Range(0, count).Select(row => Row(row, columns, separator) + end));

    public static byte[] Utf8(string text) => Encoding.UTF8.GetBytes(text);

    public static float[] Values(int row, int columns = 946) => [.. Enumerable.Range(0, columns).Select(column => Value(row, column))];

    private static string Word(float value, int column) =>
        value.ToString(column is 336 or 337 ? "0" : "0.0000", CultureInfo.InvariantCulture);
}
