using System.Text;

namespace NeuronMocap.Bvh;

// Classifies and compares the bytes and words of a BVH file.
internal static class BvhWord
{
    private const int LongestQuote = 40;

    public static bool IsSpace(byte letter) => letter == ' ' || (letter >= '\t' && letter <= '\r');

    public static bool IsLineEnd(byte letter) => letter is (byte)'\r' or (byte)'\n';

    /// <summary>Whether it is a byte that can follow the end of a text: Ctrl-Z, by which old programs end it, or NUL, from a crash or a fixed block size.</summary>
    public static bool IsPadding(byte letter) => letter is 0 or 0x1A;

    public static bool IsBrace(byte letter) => letter is (byte)'{' or (byte)'}';

    public static byte ToLower(byte letter) => letter is >= (byte)'A' and <= (byte)'Z' ? (byte)(letter | 0x20) : letter;

    public static bool AreEqual(ReadOnlySpan<byte> word, ReadOnlySpan<byte> keyword) =>
        word.Length == keyword.Length && StartsWith(word, keyword);

    /// <summary>Compares without regard to the case of ASCII letters.</summary>
    public static bool StartsWith(ReadOnlySpan<byte> word, ReadOnlySpan<byte> keyword)
    {
        if (word.Length < keyword.Length)
            return false;

        for (int i = 0; i < keyword.Length; i++)
        {
            if (ToLower(word[i]) != ToLower(keyword[i]))
                return false;
        }

        return true;
    }

    public static ReadOnlySpan<byte> Trim(ReadOnlySpan<byte> text)
    {
        while (text.Length > 0 && IsSpace(text[0]))
            text = text[1..];
        while (text.Length > 0 && IsSpace(text[^1]))
            text = text[..^1];

        return text;
    }

    /// <summary>Counts the digits after the decimal point of a number. A number with an exponent has 0.</summary>
    public static int CountDecimals(ReadOnlySpan<byte> number)
    {
        int point = number.IndexOf((byte)'.');
        ReadOnlySpan<byte> decimals = number[(point + 1)..];
        return point < 0 || !AreDigits(decimals) ? 0 : decimals.Length;
    }

    /// <summary>Whether it is a number with a comma in place of the decimal point.</summary>
    public static bool IsDecimalComma(ReadOnlySpan<byte> word)
    {
        ReadOnlySpan<byte> digits = word[(word.Length > 0 && word[0] is (byte)'-' or (byte)'+' ? 1 : 0)..];
        int comma = digits.IndexOf((byte)',');
        return comma > 0 && comma < digits.Length - 1 && AreDigits(digits[..comma]) && AreDigits(digits[(comma + 1)..]);
    }

    /// <summary>Quotes the start of a text, for a message.</summary>
    public static string Quote(ReadOnlySpan<byte> text) =>
        Quote(Encoding.UTF8.GetString(text[..Math.Min(text.Length, LongestQuote)]), isCut: text.Length > LongestQuote);

    /// <summary>Quotes the start of a text, for a message.</summary>
    public static string Quote(string text) => Quote(text.AsSpan(0, Math.Min(text.Length, LongestQuote)), isCut: text.Length > LongestQuote);

    private static bool AreDigits(ReadOnlySpan<byte> text)
    {
        foreach (byte letter in text)
        {
            if (letter is < (byte)'0' or > (byte)'9')
                return false;
        }

        return true;
    }

    private static string Quote(ReadOnlySpan<char> start, bool isCut)
    {
        var quote = new StringBuilder(LongestQuote + 5).Append('\'');
        foreach (char letter in start)
            quote.Append(char.IsControl(letter) ? '?' : letter);

        return quote.Append(isCut ? "...'" : "'").ToString();
    }
}
