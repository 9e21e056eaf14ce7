using System.Globalization;
using System.Text;

namespace NeuronMocap.Fuzz.Inputs;

/// <summary>Lines of the text stream, single and in sequence, with packets between them.</summary>
internal static class TextFixtures
{
    /// <summary>Line ends, separators, tokens, and numbers in all notations that servers use.</summary>
    public static IReadOnlyList<byte[]> Words { get; } =
    [
        .. ((string[])
        [
            "||", "|", "\r\n", "\n", "\r", "\t", " ", "\0", "0 Char00 ", "\n1 7 ", "-0.00", "+1", ".5", "5.", "1e3", "1e-46", "1e39", "0,5", "nan",
            "-nan(ind)", "1.#QNAN", "-1.#IND", "inf", "-1.#INF00", "16777217", "1.00000017881393432617187500000000001", "4294967296 A ", "演员一",
            "0 Anna Lena ", "2 Char 02 ",
        ]).Select(Encoding.UTF8.GetBytes),
        [0xFF, 0xDD], [0xFF, 0xEE], [0xCF, 0xDC], [0xCF, 0xEC], [0xFF], [0x80],
    ];

    public static IReadOnlyList<byte[]> Create()
    {
        byte[][] lines =
        [
            .. ((int[])[354, 180, 360, 186, 338, 946]).Select(count => Line("0 Char00 ", count, " ||\r\n")),
            .. ((int[])[338, 946]).Select(count => Line("", count, "\n")),
            Line("3 7 ", 180, "||"),
            Line("1 演员一 ", 180, "||\0\0"),
            Line("0 Char00 ", 179, "||\r\n"),
        ];
        byte[] packet = PacketFixtures.Create()[1];
        return [.. lines, [.. lines[1], .. packet, .. lines[3], .. lines[8], .. packet, .. lines[9]], [.. lines[0][777..], .. lines[1]]];
    }

    private static byte[] Line(string lead, int count, string end) => Encoding.UTF8.GetBytes(
        lead + string.Join(' ', Enumerable.Range(0, count).Select(index => ((index * 37 % 360) - 180 + (index / 8f)).ToString("0.00", CultureInfo.InvariantCulture))) + end);
}
