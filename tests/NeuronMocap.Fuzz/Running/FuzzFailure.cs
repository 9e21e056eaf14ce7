namespace NeuronMocap.Fuzz.Running;

/// <summary>A forbidden behaviour of a target.</summary>
/// <param name="Kind">The exception's type, or the broken rule. Failures of the same kind count as the same fault.</param>
/// <param name="Description">A full description.</param>
internal sealed record FuzzFailure(string Kind, string Description)
{
    /// <summary>Where the library threw the exception. Empty for other failures.</summary>
    public string Place { get; init; } = string.Empty;

    public bool IsLike(FuzzFailure? other) => other?.Kind == Kind && other.Place == Place;
}

/// <summary>A failure and the input that causes it.</summary>
/// <param name="Target">Name of the target.</param>
/// <param name="Failure">What happened.</param>
/// <param name="Number">Number of the input. Negative for an input of the folder corpus.</param>
/// <param name="Original">The input.</param>
/// <param name="Smallest">The input without everything that the failure does not need.</param>
internal sealed record FailingInput(string Target, FuzzFailure Failure, long Number, byte[] Original, byte[] Smallest);
