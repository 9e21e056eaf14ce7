using NeuronMocap.Transport;

namespace NeuronMocap.Diagnostics;

// Judges a stream that contains no packets.
internal static class ForeignBytes
{
    private const string OtherProgramAdvice =
        "Check the port against the one in the server's broadcasting settings; it is usually 7001.";

    private const string TooManyAdvice =
        "No Perception Neuron server sends that many; check the port. If it is correct, raise MaxValues.";

    public static Conclusion Judge(StepLog log, StreamSample sample, StreamEndpoint endpoint)
    {
        FormatGuess guess = sample.Guess();
        string quoted = guess.Format is ForeignFormat.OtherProgram or ForeignFormat.Text or ForeignFormat.AmbiguousName or ForeignFormat.MissingAvatar or ForeignFormat.Unknown && sample.Quote() is { } quote
            ? $" (\"{quote}\")"
            : string.Empty;
        (DiagnosisVerdict verdict, string? advice) = guess.Format switch
        {
            ForeignFormat.UnknownVersion => (DiagnosisVerdict.UnknownVersion, guess.Advice),
            ForeignFormat.TooManyValues => (DiagnosisVerdict.TooManyValues, TooManyAdvice),
            ForeignFormat.Incomplete => (DiagnosisVerdict.IncompletePackets, IncompleteAdvice(endpoint)),
            ForeignFormat.Text => (DiagnosisVerdict.MalformedText, $"{ServerSettings.Skeleton} Or change to binary. {ServerSettings.Binary}"),
            ForeignFormat.AmbiguousName or ForeignFormat.MissingAvatar => (DiagnosisVerdict.MalformedText, guess.Advice),
            ForeignFormat.AdvancedBvh => (DiagnosisVerdict.AdvancedBvh, guess.Advice),
            ForeignFormat.CommandReply => (DiagnosisVerdict.CommandPort, guess.Advice),
            ForeignFormat.OtherProgram => (DiagnosisVerdict.OtherProgram, OtherProgramAdvice),
            _ => (DiagnosisVerdict.UnknownFormat, $"{OtherProgramAdvice} {ServerSettings.Binary}"),
        };
        log.Failed(StepOf(guess.Format), $"{guess.Text}{quoted}");
        return new Conclusion([new ExplainedVerdict(verdict, $"Data arrives on {endpoint}, but it is {guess.Text}{quoted}.", advice)], sample);
    }

    private static string StepOf(ForeignFormat format) => format switch
    {
        ForeignFormat.UnknownVersion => "version",
        ForeignFormat.TooManyValues or ForeignFormat.Incomplete or ForeignFormat.Text or ForeignFormat.AmbiguousName or ForeignFormat.MissingAvatar => "format",
        _ => "token",
    };

    private static string IncompleteAdvice(StreamEndpoint endpoint) => endpoint.Transport == TransportKind.Udp
        ? "A frame is larger than a network packet, and a firewall or router drops the second part. Either choose TCP here and on the server, or clear "
            + "Displacement in the server's output format, which makes frames small enough."
        : "The connection ends in the middle of a frame. Look for the cause: a relay, a VPN or a firewall.";
}
