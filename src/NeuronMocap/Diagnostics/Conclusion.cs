namespace NeuronMocap.Diagnostics;

// The place that frames come from. Source is the name of a source, which then replaces the port.
internal readonly record struct StreamEndpoint(TransportKind Transport, string Host, int Port, string? Source = null)
{
    public override string ToString() =>
        Source ?? (Transport == TransportKind.Udp ? $"UDP port {Port} of this computer" : $"TCP port {Port} of {Host}");
}

// The result of an examination. Endpoint: where frames of the wanted kind can be received now, if anywhere.
internal sealed record Conclusion(IReadOnlyList<ExplainedVerdict> Verdicts, StreamSample? Sample = null, StreamEndpoint? Endpoint = null)
{
    // The data that arrived on a separate calculation port.
    public StreamSample? CalculationSample { get; init; }

    public IEnumerable<StreamSample> Samples
    {
        get
        {
            if (Sample is not null)
                yield return Sample;
            if (CalculationSample is not null)
                yield return CalculationSample;
        }
    }

    public Conclusion(DiagnosisVerdict verdict, string text, string? advice)
        : this([new ExplainedVerdict(verdict, text, advice)])
    {
    }
}
