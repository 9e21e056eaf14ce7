using NeuronMocap.Fuzz.Inputs;

namespace NeuronMocap.Fuzz.Grammar;

/// <summary>Knows the parts of a format, so that a change can swap, double or remove whole parts.</summary>
internal interface IGrammar
{
    /// <summary>Finds parts of one kind: lines, blocks, columns, numbers. They are in order and do not overlap.</summary>
    /// <param name="input">Any bytes, including bytes that were changed before.</param>
    /// <param name="random">Chooses the kind.</param>
    /// <param name="parts">Receives the parts.</param>
    void Split(ReadOnlySpan<byte> input, ref FuzzRandom random, List<Part> parts);

    /// <summary>Replacements for a number: the ends of its range, and texts that are not numbers.</summary>
    IReadOnlyList<byte[]> Extremes { get; }

    /// <summary>Finds numbers.</summary>
    void FindNumbers(ReadOnlySpan<byte> input, ref FuzzRandom random, List<Part> numbers);
}

/// <summary>Bytes that belong together.</summary>
internal readonly record struct Part(int Start, int Length)
{
    public int End => Start + Length;
}
