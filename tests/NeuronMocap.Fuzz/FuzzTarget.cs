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

    /// <summary>Whether it hands work to other threads, so that what the whole process allocates is counted.</summary>
    public bool AllocatesOnOtherThreads { get; init; }

    /// <summary>How many bytes it gets beside the others, whose share is 1: less for one that does much with each.</summary>
    public double Share { get; init; } = 1;

    /// <summary>Bytes that it may write to disk for an input of any length.</summary>
    public long OutputPerInput { get; init; } = 64 * 1024 * 1024;

    /// <summary>How many bytes it has written to disk for the input at hand, asked by another thread; null where it writes none.</summary>
    public Func<long>? CountOutput { get; init; }

    /// <summary>Asks the code that reads the input at hand to end, from another thread; null where nothing can. Called once, at the end of a run.</summary>
    public Action? Stop { get; init; }

    /// <summary>An input that takes longer is a hang. Ten thousand times what one takes, so that a busy machine is none.</summary>
    public TimeSpan TimeLimit { get; init; } = TimeSpan.FromSeconds(60);
}

/// <summary>
/// Reads an input, reports all it found to the digest, and throws <see cref="WrongResultException"/> where two readings of it differ.
/// </summary>
internal delegate void FuzzTest(FuzzInput input);
