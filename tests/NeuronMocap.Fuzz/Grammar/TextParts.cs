using NeuronMocap.Fuzz.Inputs;

namespace NeuronMocap.Fuzz.Grammar;

/// <summary>Lines and words of a text.</summary>
internal static class TextParts
{
    /// <summary>Finds lines, including their ends.</summary>
    public static void FindLines(ReadOnlySpan<byte> text, List<Part> parts)
    {
        for (int start = 0; start < text.Length;)
        {
            int end = text[start..].IndexOfAny((byte)'\n', (byte)'\r');
            int length = end < 0 ? text.Length - start : end + 1;
            if (end >= 0 && text[start + end] == '\r' && start + length < text.Length && text[start + length] == '\n')
                length++;

            parts.Add(new Part(start, length));
            start += length;
        }
    }

    public static void FindWords(ReadOnlySpan<byte> text, int offset, List<Part> parts)
    {
        for (int at = 0; at < text.Length;)
        {
            while (at < text.Length && IsSpace(text[at]))
                at++;

            int start = at;
            while (at < text.Length && !IsSpace(text[at]))
                at++;

            if (at > start)
                parts.Add(new Part(offset + start, at - start));
        }
    }

    /// <summary>Finds the words of one column, in all lines with as many words as the chosen line.</summary>
    public static void FindColumn(ReadOnlySpan<byte> text, ref FuzzRandom random, List<Part> parts)
    {
        var lines = new List<Part>();
        var words = new List<Part>();
        FindLines(text, lines);
        if (lines.Count == 0)
            return;

        FindWordsOf(text, random.Choose(lines), words);
        if (words.Count == 0)
            return;

        int count = words.Count;
        int column = random.Below(count);
        foreach (Part line in lines)
        {
            words.Clear();
            FindWordsOf(text, line, words);
            if (words.Count == count)
                parts.Add(words[column]);
        }
    }

    public static void FindNumbers(ReadOnlySpan<byte> text, List<Part> numbers)
    {
        var words = new List<Part>();
        FindWords(text, 0, words);
        foreach (Part word in words)
        {
            byte first = text[word.Start];
            if (first is (>= (byte)'0' and <= (byte)'9') or (byte)'-' or (byte)'+' or (byte)'.')
                numbers.Add(word);
        }
    }

    private static void FindWordsOf(ReadOnlySpan<byte> text, Part line, List<Part> words) => FindWords(text.Slice(line.Start, line.Length), line.Start, words);

    private static bool IsSpace(byte letter) => letter is (byte)' ' or (>= (byte)'\t' and <= (byte)'\r');
}
