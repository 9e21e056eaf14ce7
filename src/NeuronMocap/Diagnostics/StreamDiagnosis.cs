namespace NeuronMocap.Diagnostics;

/// <summary>What a diagnosis found out about a stream, or about its absence.</summary>
public sealed record StreamDiagnosis
{
    internal StreamDiagnosis()
    {
    }

    /// <summary>The most important thing that was found.</summary>
    public DiagnosisVerdict Verdict => Verdicts[0];

    /// <summary>Everything that was found, the most important first; never empty.</summary>
    public IReadOnlyList<DiagnosisVerdict> Verdicts { get; init; } = [DiagnosisVerdict.Receiving];

    /// <summary>Whether the frames that were asked for arrive where the reader would look for them.</summary>
    public bool IsReceiving => Verdict < DiagnosisVerdict.HostNotFound;

    /// <summary>The verdict in a few words of English, such as "Nothing listens on this port".</summary>
    public string Title => DiagnosisTitles.Of(Verdict);

    /// <summary>One paragraph of English for the operator: what is the case, why, and which setting to change.</summary>
    public string Summary { get; init; } = string.Empty;

    /// <summary>The part of the summary that says which setting to change; null when nothing has to be changed.</summary>
    public string? Advice { get; init; }

    /// <summary>
    /// Lines of C# that receive the stream as it is sent now, even when that is on another port than the one asked for; null when no frames
    /// were found.
    /// </summary>
    public string? SampleCode { get; init; }

    /// <summary>The steps in their order; the same that were reported while the diagnosis ran.</summary>
    public IReadOnlyList<DiagnosisStep> Steps { get; init; } = [];

    /// <summary>The avatars of the stream, by number; empty when no frames came from the port that was asked for.</summary>
    public IReadOnlyList<DiagnosedAvatar> Avatars { get; init; } = [];

    /// <summary>How long the diagnosis took.</summary>
    public TimeSpan Elapsed { get; init; }

    /// <summary>The verdict and the summary.</summary>
    /// <returns>A line for a log.</returns>
    public override string ToString() => $"{Verdict}: {Summary}";
}
