using System.Globalization;
using System.Text;
using System.Text.RegularExpressions;
using NeuronMocap.Protocol;
using NeuronMocap.Tests.Protocol;

namespace NeuronMocap.Tests.Infrastructure;

/// <summary>The meaning of a position in a stream to the text format: whether a line may start there.</summary>
internal enum ReferencePlace
{
    Start,
    Unsure,
    BehindLine,
    Noise,
}

/// <summary>The kind of text at a position where a line may start.</summary>
internal enum ReferenceLineKind
{
    NoLine,
    Unfinished,
    Frame,
    Refused,
}

/// <param name="Kind">The kind.</param>
/// <param name="Length">The number of bytes, including the end.</param>
/// <param name="Packet">The frame.</param>
/// <param name="Reason">Why it is not a frame.</param>
/// <param name="Place">The meaning of the position after it.</param>
internal sealed record ReferenceLine(ReferenceLineKind Kind, int Length = 0, FoundPacket? Packet = null, SkipReason Reason = default, ReferencePlace Place = ReferencePlace.Start);

/// <summary>The rules of the text format (protocol.md section 8), implemented slowly.</summary>
internal static class ReferenceText
{
    private const int LongestLine = 32_768;

    private static readonly Regex Finite = new(@"^[+-]?(\d+(\.\d*)?|\.\d+)([eE][+-]?\d+)?$", RegexOptions.ExplicitCapture, TimeSpan.FromSeconds(5));

    private static readonly Regex NotFinite = new(@"^[+-]?(1\.#)?(?<what>inf|nan|ind|qnan|snan)(\(.*|\d*|inity)$", RegexOptions.IgnoreCase | RegexOptions.ExplicitCapture, TimeSpan.FromSeconds(5));

    public static bool IsBlank(byte value) => value is 0 or 32 or 9 or 13 or 10;

    /// <summary>Reads the text at a position that is not blank.</summary>
    public static ReferenceLine ReadAt(ReadOnlySpan<byte> bytes, int maxValues, bool isUnsure)
    {
        if (!"0123456789+-.,nNiI".Contains((char)bytes[0], StringComparison.Ordinal))
            return new ReferenceLine(ReferenceLineKind.NoLine);

        var text = new StringBuilder(" ");
        int word = 0;
        for (int i = 0; i < Math.Min(bytes.Length, LongestLine); i++)
        {
            char letter = (char)bytes[i];
            if (letter == '\0')
                continue;

            char last = text[^1];
            text.Append(letter);
            if (letter == '\n' || (letter == '|' && last == '|'))
                return Judge(text.ToString(), i + 1, maxValues, isUnsure);

            if (!IsBetweenWords(letter) && IsBetweenWords(last))
                word++;
            if (!MayStand(word, letter, last))
                return new ReferenceLine(ReferenceLineKind.NoLine);
        }

        return bytes.Length < LongestLine
            ? new ReferenceLine(ReferenceLineKind.Unfinished)
            : new ReferenceLine(ReferenceLineKind.Refused, LongestLine - 1, Reason: SkipReason.MalformedLine, Place: ReferencePlace.Noise);
    }

    /// <summary>Returns whether the bytes start with a number, a name of words that are not numbers, and a number.</summary>
    public static bool BeginsTelling(ReadOnlySpan<byte> bytes)
    {
        if (bytes.Length == 0 || " \t\r\n|".Contains((char)bytes[0], StringComparison.Ordinal))
            return false;

        return IsTelling(Words(Encoding.Latin1.GetString(bytes)));
    }

    /// <summary>Returns whether an unfinished line continues after its first word.</summary>
    public static bool IsInsideLine(byte[] unfinished) =>
        Encoding.Latin1.GetString(unfinished).Replace("\0", string.Empty, StringComparison.Ordinal).AsSpan().IndexOfAny(" \t\r|") > 0;

    private static string[] Words(string line) => line.Split([' ', '\t', '\r', '\n', '|'], StringSplitOptions.RemoveEmptyEntries);

    private static bool IsTelling(string[] words) =>
        words.Length > 2 && IsIndex(words[0]) && ParseNumber(words[1]) is null && words.Skip(2).Any(word => ParseNumber(word) is not null);

    private static bool IsBetweenWords(char letter) => letter is ' ' or '\t' or '\r' or '|';

    private static bool MayStand(int word, char letter, char last)
    {
        if (IsBetweenWords(letter))
            return true;
        if (letter >= 0x80)
            return word is >= 2 and <= 17 && letter != 0xFF && !(letter == 0xDC && last == 0xCF);

        return letter is > ' ' and <= '~' && (word > 1 || "0123456789+-.,#()aAdDeEfFiInNqQsStTyY".Contains(letter, StringComparison.Ordinal));
    }

    private static ReferenceLine Judge(string line, int length, int maxValues, bool isUnsure)
    {
        string[] words = Words(line);
        bool isTelling = IsTelling(words);
        if (isUnsure && !isTelling)
            return new ReferenceLine(ReferenceLineKind.Refused, length);

        // A name of one word, whatever it is, or else of all words before the first number.
        int[] nameSizes = [1, .. isTelling ? (int[])[words.Skip(1).TakeWhile(word => ParseNumber(word) is null).Count()] : []];
        bool isTooLarge = false;
        foreach (int nameSize in nameSizes)
        {
            (int count, bool isLed) = words.Length - nameSize + 1 is 338 or 946 ? (words.Length - nameSize + 1, false) : (words.Length - nameSize - 1, true);
            if (!IsFrame(count))
                continue;

            float?[] values = [.. words.Skip(words.Length - count).Select(ParseNumber)];
            if (count > maxValues)
                isTooLarge = true;
            else if (values.All(value => value is not null) && (isLed ? IsIndex(words[0]) : count == words.Length))
                return Frame(isLed ? words[0] : "0", isLed ? NameIn(line, nameSize) : string.Empty, [.. values.Select(value => value!.Value)], length);
        }

        bool isLike = isTelling || (words.Length > 2 && ParseNumber(words[0]) is not null && ParseNumber(words[2]) is not null);
        SkipReason reason = isTooLarge ? SkipReason.TooLarge
            : !isLike ? SkipReason.NoTokens
            : isTelling && Enumerable.Range(1, 5).Any(excess => IsFrame(words.Length - 2 - excess)) ? SkipReason.AmbiguousName
            : !isTelling && words.Length is 180 or 186 or 354 or 360 ? SkipReason.MissingAvatar
            : SkipReason.MalformedLine;
        return new ReferenceLine(ReferenceLineKind.Refused, length, Reason: reason);
    }

    private static bool IsFrame(int count) => count is 180 or 186 or 354 or 360 or 338 or 946;

    private static string NameIn(string line, int words)
    {
        string word = @"[^ \t\r\n|]+";
        string gap = @"[ \t\r\n|]+";
        return Regex.Match(line, $"^{gap}{word}{gap}(?<name>{word}({gap}{word}){{{words - 1}}})", RegexOptions.ExplicitCapture, TimeSpan.FromSeconds(5)).Groups["name"].Value;
    }

    private static ReferenceLine Frame(string avatar, string name, float[] values, int length)
    {
        (uint count, uint index, byte[] cut) = ((uint)values.Length, uint.Parse(avatar, CultureInfo.InvariantCulture), Cut(Encoding.Latin1.GetBytes(name)));
        bool isMotion = count is not (338 or 946);
        var image = new WireBytes();
        if (isMotion)
            image.Hex("FF DD 00 00 00 00").U32(count).U32(count > 300 ? 1u : 0).U32(count is 186 or 360 ? 1u : 0).U32(index).Bytes(cut, 32).Zeros(10);
        else
            image.Hex("FF 88 00 00 00 00").U32(count).U32(index).Bytes(cut, 32).Zeros(18);

        var packet = new FoundPacket(isMotion ? PacketKind.Motion : PacketKind.Calculation, image.Floats(values).ToArray());
        return new ReferenceLine(ReferenceLineKind.Frame, length, packet, Place: ReferencePlace.BehindLine);
    }

    private static bool IsIndex(string word) => word.All(char.IsAsciiDigit) && decimal.Parse(word, CultureInfo.InvariantCulture) <= uint.MaxValue;

    private static byte[] Cut(byte[] name)
    {
        int length = Math.Min(name.Length, 32);
        while (length is > 0 and < 33 && length < name.Length && name[length] is >= 0x80 and < 0xC0)
            length--;

        return name[..length];
    }

    private static float? ParseNumber(string word)
    {
        int comma = word.IndexOf(',', StringComparison.Ordinal);
        if (comma >= 0)
            word = $"{word[..comma]}.{word[(comma + 1)..]}";
        if (word.Length > 128)
            return null;
        if (Finite.IsMatch(word))
            return ExactDecimal.ToSingle(word);
        if (NotFinite.Match(word) is not { Success: true } match)
            return null;

        bool isInfinite = match.Groups["what"].Value.Equals("inf", StringComparison.OrdinalIgnoreCase);
        return !isInfinite ? float.NaN : word[0] == '-' ? float.NegativeInfinity : float.PositiveInfinity;
    }
}
