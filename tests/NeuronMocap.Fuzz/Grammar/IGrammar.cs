using NeuronMocap.Fuzz.Inputs;

namespace NeuronMocap.Fuzz.Grammar;

/// <summary>Knows of what a format is made, so that a change can swap, double or remove what belongs together.</summary>
internal interface IGrammar
{
    /// <summary>Finds parts of one kind: lines, blocks, columns, numbers. They lie one behind the other and do not overlap.</summary>
    /// <param name="input">Any bytes, also such as were changed before.</param>
    /// <param name="random">Chooses the kind.</param>
    /// <param name="parts">Receives them.</param>
    void Split(ReadOnlySpan<byte> input, ref FuzzRandom random, List<Part> parts);

    /// <summary>What a number may become: each end of its range, and what is no number.</summary>
    IReadOnlyList<byte[]> Extremes { get; }

    /// <summary>Finds numbers.</summary>
    void FindNumbers(ReadOnlySpan<byte> input, ref FuzzRandom random, List<Part> numbers);
}

/// <summary>Bytes that belong together.</summary>
internal readonly record struct Part(int Start, int Length)
{
    public int End => Start + Length;
}
