namespace NeuronMocap.Diagnostics;

/// <summary>The outcome of a diagnosis step.</summary>
public enum StepOutcome
{
    /// <summary>The step succeeded.</summary>
    Ok,

    /// <summary>The step succeeded, but its detail deserves attention.</summary>
    Warning,

    /// <summary>The step failed: the stream is interrupted here.</summary>
    Failed,
}

/// <summary>One step of a diagnosis, between the host's name and the frame rate.</summary>
/// <param name="Name">
/// Name of the step: "name" or "source", "route", "networks", "port", "buffer", "first bytes", "token", "version", "format" or "rate". If a step fails, also
/// "question", "other ports" and "UDP" or "TCP", the other possible places of the stream.
/// </param>
/// <param name="Outcome">The outcome of the step.</param>
/// <param name="Detail">The observation, as an English phrase.</param>
/// <param name="Elapsed">Duration of the step.</param>
public sealed record DiagnosisStep(string Name, StepOutcome Outcome, string Detail, TimeSpan Elapsed)
{
    /// <summary>Gets the name, the outcome and the detail.</summary>
    /// <returns>A line for a log.</returns>
    public override string ToString() => $"{Name}: {Outcome}: {Detail}";
}
