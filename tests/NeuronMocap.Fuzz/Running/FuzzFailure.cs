namespace NeuronMocap.Fuzz.Running;

/// <summary>What a target did that it may not.</summary>
/// <param name="Kind">Failures of one kind are taken for the same fault: an exception's type, or the promise that was broken.</param>
/// <param name="Description">All that is known.</param>
internal sealed record FuzzFailure(string Kind, string Description)
{
    /// <summary>Where in the library an exception was thrown; empty for other failures.</summary>
    public string Place { get; init; } = string.Empty;

    public bool IsLike(FuzzFailure? other) => other?.Kind == Kind && other.Place == Place;
}

/// <summary>A failure and the input that shows it.</summary>
/// <param name="Target">Name of the target.</param>
/// <param name="Failure">What happened.</param>
/// <param name="Number">Number of the input; below 0 for one that was kept from before.</param>
/// <param name="Original">The input.</param>
/// <param name="Smallest">What is left of it when everything is taken away that the failure does not need.</param>
internal sealed record FailingInput(string Target, FuzzFailure Failure, long Number, byte[] Original, byte[] Smallest);
