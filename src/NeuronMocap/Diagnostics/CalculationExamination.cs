using NeuronMocap.Transport;

namespace NeuronMocap.Diagnostics;

// Examines the port of calculation data after the first port, in the remaining time.
internal static class CalculationExamination
{
    // The second port gets at least this time, however long the first port took. A server on the network answers in less time.
    private static readonly TimeSpan Least = TimeSpan.FromSeconds(1);

    public static async Task<Conclusion> AddAsync(
        DiagnosisContext context, LinkOptions link, Conclusion first, Func<DiagnosisContext, Task<Conclusion>> examine)
    {
        DiagnosisOptions how = context.Options.Copy();
        how.Expected = context.Expected == PacketKind.StudioCalculation ? PacketKind.StudioCalculation : PacketKind.Calculation;
        how.SearchOtherPorts = false;
        how.Timeout = context.Options.Timeout - context.Elapsed > Least ? context.Options.Timeout - context.Elapsed : Least;
        Conclusion second = await examine(new DiagnosisContext(link, how, context.Log.With("calculation "), context.CancellationToken)).ConfigureAwait(false);
        ExplainedVerdict found = second.Verdicts[0];
        var joint = first with { CalculationSample = second.Sample };

        // Axis Studio's calculation data has its own kind of packet, but is calculation data too.
        if (!found.IsFault || found.Verdict == DiagnosisVerdict.StudioCalculationOnly)
            return joint with { Verdicts = [.. first.Verdicts.Select((verdict, index) => index == 0 ? AddCalculationPort(verdict, link.Port) : verdict)] };

        var missing = new ExplainedVerdict(
            DiagnosisVerdict.CalculationUnavailable,
            $"Calculation port {link.Port}: {(found.Verdict == DiagnosisVerdict.Refused ? "connection refused. " : string.Empty)}{found.Text}",
            found.Advice);
        bool isAllElse = first.Verdicts is [{ Verdict: DiagnosisVerdict.Receiving }];
        return joint with { Verdicts = isAllElse ? [missing with { Text = $"{first.Verdicts[0].Text} {missing.Text}" }] : [.. first.Verdicts, missing] };
    }

    private static ExplainedVerdict AddCalculationPort(ExplainedVerdict verdict, int port) => verdict with { Text = $"{verdict.Text} Calculation port {port}: frames arrive." };
}
