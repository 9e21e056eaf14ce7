using System.Globalization;
using System.Text;
using System.Text.Encodings.Web;

namespace NeuronMocap.Tool.Terminal;

/// <summary>Makes text from the network or from a file safe for a terminal and for one line.</summary>
/// <remarks>
/// Code that writes text to a terminal, a log or a picture calls <see cref="Clean"/> directly there, so that no text is missed. JSON keeps the exact
/// text and escapes the same characters: see <see cref="JsonEncoder"/>.
/// </remarks>
internal static class TerminalText
{
    private const char Replacement = '·';

    /// <summary>Writes text unchanged, with an escape for each character that <see cref="Clean"/> would replace.</summary>
    public static JavaScriptEncoder JsonEncoder { get; } = CreateJsonEncoder();

    /// <summary>Replaces characters that are unsafe in a terminal.</summary>
    /// <remarks>
    /// Unsafe characters can move the cursor, start an escape sequence, end the line, or change the direction of the letters around them. They are
    /// control characters including C1, format characters such as U+202E, line separators, halves of surrogate pairs, and code points without a
    /// character.
    /// </remarks>
    public static string Clean(string text)
    {
        int first = FindUnsafe(text, 0);
        if (first < 0)
            return text;

        var clean = new StringBuilder(text.Length);
        int start = 0;
        for (int i = first; i >= 0; i = FindUnsafe(text, start))
        {
            clean.Append(text, start, i - start).Append(Replacement);
            Rune.DecodeFromUtf16(text.AsSpan(i), out _, out int length);
            start = i + length;
        }

        return clean.Append(text, start, text.Length - start).ToString();
    }

    private static int FindUnsafe(string text, int start)
    {
        for (int i = start; i < text.Length;)
        {
            // Half of a surrogate pair decodes to another character.
            if (Rune.DecodeFromUtf16(text.AsSpan(i), out Rune rune, out int length) != System.Buffers.OperationStatus.Done || !IsSafe(rune))
                return i;

            i += length;
        }

        return -1;
    }

    // The joiners shape letters of some scripts and emoji. They do not change the direction of text.
    private static bool IsSafe(Rune rune) => rune.Value is 0x200C or 0x200D
        || ((rune.Value & 0xFFFE) != 0xFFFE && Rune.GetUnicodeCategory(rune) is not
            (UnicodeCategory.Control or UnicodeCategory.Format or UnicodeCategory.LineSeparator or UnicodeCategory.ParagraphSeparator));

    private static JavaScriptEncoder CreateJsonEncoder()
    {
        var settings = new TextEncoderSettings();
        for (int letter = 0; letter <= char.MaxValue; letter++)
        {
            if (Rune.TryCreate(letter, out Rune rune) && IsSafe(rune))
                settings.AllowCharacter((char)letter);
        }

        return JavaScriptEncoder.Create(settings);
    }
}
