using System.Text;
using NeuronMocap.Fuzz.Inputs;

namespace NeuronMocap.Fuzz.Grammar;

/// <summary>Joints with their descendants, End Sites, lines, columns of the motion, words.</summary>
internal sealed class BvhGrammar : IGrammar
{
    private static readonly string[] Blocks = ["JOINT", "End", "ROOT", "OFFSET", "CHANNELS", "MOTION", "Frame"];

    private readonly List<Part> _words = [];

    public IReadOnlyList<byte[]> Extremes { get; } = NumberWords.Extremes;

    public void Split(ReadOnlySpan<byte> input, ref FuzzRandom random, List<Part> parts)
    {
        switch (random.Below(5))
        {
            case 0:
                TextParts.FindLines(input, parts);
                break;
            case 1:
                TextParts.FindColumn(input, ref random, parts);
                break;
            case 2:
                TextParts.FindWords(input, 0, parts);
                break;
            default:
                FindBlocks(input, random.Choose(Blocks), parts);
                break;
        }
    }

    public void FindNumbers(ReadOnlySpan<byte> input, ref FuzzRandom random, List<Part> numbers)
    {
        if (random.Below(4) == 0)
            TextParts.FindColumn(input, ref random, numbers);
        else
            TextParts.FindNumbers(input, numbers);
    }

    // From a keyword to its closing brace, or to the next keyword of its kind. Of nested blocks, the outermost or a single inner one.
    private void FindBlocks(ReadOnlySpan<byte> text, string keyword, List<Part> parts)
    {
        _words.Clear();
        TextParts.FindWords(text, 0, _words);
        byte[] expected = Encoding.ASCII.GetBytes(keyword);
        int start = -1;
        foreach (Part word in _words)
        {
            if (!text.Slice(word.Start, word.Length).SequenceEqual(expected))
                continue;

            if (start >= 0)
                parts.Add(new Part(start, EndOf(text, start, word.Start) - start));

            start = word.Start;
        }

        if (start >= 0)
            parts.Add(new Part(start, EndOf(text, start, text.Length) - start));
    }

    private static int EndOf(ReadOnlySpan<byte> text, int start, int limit)
    {
        int depth = 0;
        for (int at = start; at < limit; at++)
        {
            if (text[at] == '{')
                depth++;
            else if (text[at] == '}' && --depth <= 0)
                return depth == 0 ? at + 1 : at;
        }

        return limit;
    }
}
