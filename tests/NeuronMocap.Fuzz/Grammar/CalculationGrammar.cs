using NeuronMocap.Fuzz.Inputs;

namespace NeuronMocap.Fuzz.Grammar;

/// <summary>Rows, columns and words of a calculation export, and the sixteen values of a bone.</summary>
internal sealed class CalculationGrammar : IGrammar
{
    private const int ValuesOfABone = 16;

    private readonly List<Part> _lines = [];
    private readonly List<Part> _words = [];

    public IReadOnlyList<byte[]> Extremes => NumberWords.Extremes;

    public void Split(ReadOnlySpan<byte> input, ref FuzzRandom random, List<Part> parts)
    {
        switch (random.Below(4))
        {
            case 0:
                TextParts.FindColumn(input, ref random, parts);
                break;
            case 1:
                TextParts.FindWords(input, 0, parts);
                break;
            case 2:
                FindBones(input, ref random, parts);
                break;
            default:
                TextParts.FindLines(input, parts);
                break;
        }
    }

    public void FindNumbers(ReadOnlySpan<byte> input, ref FuzzRandom random, List<Part> numbers)
    {
        if (random.Below(3) == 0)
            TextParts.FindColumn(input, ref random, numbers);
        else
            TextParts.FindNumbers(input, numbers);
    }

    private void FindBones(ReadOnlySpan<byte> text, ref FuzzRandom random, List<Part> parts)
    {
        _lines.Clear();
        _words.Clear();
        TextParts.FindLines(text, _lines);
        if (_lines.Count == 0)
            return;

        Part line = random.Choose(_lines);
        TextParts.FindWords(text.Slice(line.Start, line.Length), line.Start, _words);
        for (int bone = 0; bone + ValuesOfABone <= _words.Count; bone += ValuesOfABone)
            parts.Add(new Part(_words[bone].Start, _words[bone + ValuesOfABone - 1].End - _words[bone].Start));
    }
}
