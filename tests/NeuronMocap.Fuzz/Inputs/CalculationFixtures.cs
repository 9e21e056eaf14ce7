using System.Globalization;
using System.Text;

namespace NeuronMocap.Fuzz.Inputs;

/// <summary>Calculation exports of both widths, with and without headers, complete and truncated.</summary>
internal static class CalculationFixtures
{
    public static IReadOnlyList<byte[]> Words { get; } =
    [
        .. ((string[])[
            "\t", " ", "\r\n", "\n", "\r", "\t\r\n", "\v", "\0", "-", ".", "e", "x", "0", "1", "-0.0000", "0.0000\t", "1e39", "1e-46", "nan", "inf",
            "-1.#IND00", "16777217", "1.00000017881393432617187500000000001", "01-X-x", "contactL", ";", ",", "\u00EF\u00BB\u00BF",
        ]).Select(Encoding.Latin1.GetBytes),
    ];

    public static IReadOnlyList<byte[]> Create()
    {
        string names = string.Join('\t', Enumerable.Range(0, 338).Select(column => $"{(column / 16) + 1:00}-X-{column % 16}"));
        return
        [
            .. ((string[])[
                Rows(3, 338, "\t", "\t\r\n"),
                Rows(2, 946, " ", "\n"),
                Rows(1, 946, "\t", ""),
                $"Calculation 1.0\r\n120\r\n\r\n{names}\r\n{Rows(2, 338, "\t", "\r\n")}",
                Rows(3, 338, "\t", "\n")[..^900],
            ]).Select(Encoding.ASCII.GetBytes),
        ];
    }

    private static string Rows(int count, int columns, string separator, string end) =>
        string.Concat(Enumerable.Range(0, count).Select(row => string.Join(separator, Enumerable.Range(0, columns).Select(column => Word(row, column))) + end));

    private static string Word(int row, int column) => column is 336 or 337
        ? (row % 2).ToString(CultureInfo.InvariantCulture)
        : ((((row * 7919) + (column * 104_729)) % 20_011 / 10_000f) - 1).ToString("0.0000", CultureInfo.InvariantCulture);
}
