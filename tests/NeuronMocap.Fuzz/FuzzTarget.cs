using NeuronMocap.Fuzz.Inputs;

namespace NeuronMocap.Fuzz;

/// <summary>A parser, and what it may do with an input of any bytes.</summary>
/// <param name="Name">Its name on the command line.</param>
/// <param name="Corpus">What inputs are made of.</param>
/// <param name="CreateTest">Makes the code that reads an input; one for each run, used by one thread.</param>
internal sealed record FuzzTarget(string Name, CorpusKind Corpus, Func<FuzzTest> CreateTest)
{
    /// <summary>The exception with which the parser may refuse an input; null when it may throw none.</summary>
    public Type? Refusal { get; init; }

    /// <summary>Bytes that it may allocate for an input of any length.</summary>
    public long AllocatedPerInput { get; init; } = 8 * 1024;

    /// <summary>Further bytes that it may allocate for each byte of the input.</summary>
    public long AllocatedPerByte { get; init; }

    /// <summary>An input that takes longer is a hang. Ten thousand times what one takes, so that a busy machine is none.</summary>
    public TimeSpan TimeLimit { get; init; } = TimeSpan.FromSeconds(60);
}

/// <summary>
/// Reads an input, reports all it found to the digest, and throws <see cref="WrongResultException"/> where two readings of it differ.
/// </summary>
internal delegate void FuzzTest(FuzzInput input);
