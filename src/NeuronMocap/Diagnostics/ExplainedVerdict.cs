namespace NeuronMocap.Diagnostics;

// A verdict in words, and the setting that changes it.
internal readonly record struct ExplainedVerdict(DiagnosisVerdict Verdict, string Text, string? Advice = null)
{
    public bool IsFault => Verdict >= DiagnosisVerdict.HostNotFound;
}
