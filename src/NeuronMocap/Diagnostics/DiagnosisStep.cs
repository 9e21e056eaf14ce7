namespace NeuronMocap.Diagnostics;

/// <summary>How a step of a diagnosis ended.</summary>
public enum StepOutcome
{
    /// <summary>As it should be.</summary>
    Ok,

    /// <summary>Works, but worth a look.</summary>
    Warning,

    /// <summary>Here the chain is broken.</summary>
    Failed,
}

/// <summary>One link of the chain that a diagnosis walks from the host's name to the rate of the frames.</summary>
/// <param name="Name">
/// Which link: "name", "route", "port", "first bytes", "token", "version", "format", "rate"; where the chain breaks also "question",
/// "other ports" and "UDP" or "TCP", the places where the stream might be instead.
/// </param>
/// <param name="Outcome">How it ended.</param>
/// <param name="Detail">What was seen: a phrase in English.</param>
/// <param name="Elapsed">How long it took.</param>
public sealed record DiagnosisStep(string Name, StepOutcome Outcome, string Detail, TimeSpan Elapsed)
{
    /// <summary>Name, outcome and detail.</summary>
    /// <returns>A line for a log.</returns>
    public override string ToString() => $"{Name}: {Outcome}: {Detail}";
}
