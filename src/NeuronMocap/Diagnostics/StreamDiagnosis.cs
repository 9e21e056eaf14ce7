namespace NeuronMocap.Diagnostics;

/// <summary>The result of a diagnosis of a stream, or of its absence.</summary>
public sealed record StreamDiagnosis
{
    internal StreamDiagnosis()
    {
    }

    /// <summary>The most important verdict.</summary>
    public DiagnosisVerdict Verdict => Verdicts[0];

    /// <summary>All verdicts, the most important first; never empty.</summary>
    public IReadOnlyList<DiagnosisVerdict> Verdicts { get; init; } = [DiagnosisVerdict.Receiving];

    /// <summary>Whether the requested frames arrive at the place where the reader receives.</summary>
    public bool IsReceiving => Verdict < DiagnosisVerdict.HostNotFound;

    /// <summary>The verdict in a few English words, such as "Nothing listens on this port".</summary>
    public string Title => DiagnosisTitles.Of(Verdict);

    /// <summary>One English paragraph for the operator: the situation, its cause, and the setting to change.</summary>
    public string Summary { get; init; } = string.Empty;

    /// <summary>The part of the summary that says which setting to change; null if no change is needed.</summary>
    public string? Advice { get; init; }

    /// <summary>
    /// Lines of C# that receive the stream as it is sent now, even on another port than the requested one. Null if no frames were found.
    /// </summary>
    public string? SampleCode { get; init; }

    /// <summary>The steps in order, the same as those reported during the diagnosis.</summary>
    public IReadOnlyList<DiagnosisStep> Steps { get; init; } = [];

    /// <summary>The avatars of the stream, by number; empty if no frames arrived on the requested port.</summary>
    public IReadOnlyList<DiagnosedAvatar> Avatars { get; init; } = [];

    /// <summary>Duration of the diagnosis.</summary>
    public TimeSpan Elapsed { get; init; }

    /// <summary>Gets the verdict and the summary.</summary>
    /// <returns>A line for a log.</returns>
    public override string ToString() => $"{Verdict}: {Summary}";
}
