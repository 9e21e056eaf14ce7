using NeuronMocap.Fuzz.Inputs;

namespace NeuronMocap.Fuzz;

/// <summary>A parser, and its limits for an input of any bytes.</summary>
/// <param name="Name">Its name on the command line.</param>
/// <param name="Corpus">The kind of inputs.</param>
/// <param name="CreateTest">Creates the code that reads an input. Each run has its own, used by one thread.</param>
internal sealed record FuzzTarget(string Name, CorpusKind Corpus, Func<FuzzTest> CreateTest)
{
    /// <summary>The exception with which the parser may reject an input. Null if it may not throw.</summary>
    public Type? Refusal { get; init; }

    /// <summary>Bytes that it may allocate for an input of any length.</summary>
    public long AllocatedPerInput { get; init; } = 8 * 1024;

    /// <summary>Further bytes that it may allocate for each byte of the input.</summary>
    public long AllocatedPerByte { get; init; }

    /// <summary>Whether it passes work to other threads. The allocations of the whole process are then counted.</summary>
    public bool AllocatesOnOtherThreads { get; init; }

    /// <summary>Its share of the bytes, relative to 1 for other targets. Smaller for slow targets.</summary>
    public double Share { get; init; } = 1;

    /// <summary>Bytes that it may write to disk for an input of any length.</summary>
    public long OutputPerInput { get; init; } = 64 * 1024 * 1024;

    /// <summary>Returns the bytes written to disk for the current input. Called by another thread. Null if it writes nothing.</summary>
    public Func<long>? CountOutput { get; init; }

    /// <summary>
    /// Asks the code that reads the current input to end. Called once by another thread, at the end of a run. Null if it cannot be stopped.
    /// </summary>
    public Action? Stop { get; init; }

    /// <summary>
    /// An input that takes longer counts as a hang. The limit is ten thousand times the usual, so a busy machine does not reach it.
    /// </summary>
    public TimeSpan TimeLimit { get; init; } = TimeSpan.FromSeconds(60);
}

/// <summary>
/// Reads an input, adds all results to the digest, and throws <see cref="WrongResultException"/> if two readings of the input differ.
/// </summary>
internal delegate void FuzzTest(FuzzInput input);
