using System.Collections;
using QRCoder;
using Spectre.Console;
using Spectre.Console.Rendering;

namespace NeuronMocap.Tool.View.Access;

/// <summary>A QR code as lines of half blocks for a terminal: dark on light, whatever the colours of the terminal are.</summary>
internal static class QrPicture
{
    private const string UpperHalf = "▀";

    /// <summary>Draws a text.</summary>
    /// <param name="text">The text, such as a link.</param>
    /// <param name="columns">Columns of the terminal.</param>
    /// <returns>The picture; null if the terminal is too narrow.</returns>
    public static IRenderable? Create(string text, int columns)
    {
        using var generator = new QRCodeGenerator();
        using QRCodeData code = generator.CreateQrCode(text, QRCodeGenerator.ECCLevel.M);
        List<BitArray> rows = code.ModuleMatrix;
        if (rows.Count > columns)
            return null;

        var picture = new List<IRenderable>();
        for (int row = 0; row < rows.Count; row += 2)
            picture.Add(DrawLine(rows[row], row + 1 < rows.Count ? rows[row + 1] : null));

        return new Rows(picture);
    }

    // A character shows two modules: the upper one in its foreground, the lower one in its background.
    private static Paragraph DrawLine(BitArray upper, BitArray? lower)
    {
        var line = new Paragraph();
        for (int column = 0; column < upper.Count; column++)
            line.Append(UpperHalf, new Style(ColorOf(upper[column]), ColorOf(lower is not null && lower[column])));

        return line;
    }

    private static Color ColorOf(bool isDark) => isDark ? Color.Black : Color.White;
}
