using NeuronMocap.Diagnostics;
using NeuronMocap.Reader;
using NeuronMocap.Transport;

namespace NeuronMocap;

/// <summary>
/// Answers "no data": walks the chain from the server's name to the rate of its frames, and says where it breaks and which setting of Axis
/// Neuron or Axis Studio to change.
/// </summary>
public static class NeuronDiagnostics
{
    /// <summary>
    /// Tries to receive as a reader with these options would, looks at what arrives, and elsewhere where nothing does. It connects on its
    /// own, beside any reader; over UDP it binds the port, so a reader of the same port has to be stopped before, or to share it. Of a shared
    /// port it takes the datagrams that are sent to this computer alone, and the reader gets none of them meanwhile.
    /// </summary>
    /// <param name="options">
    /// The options of the reader that gets no data. Over UDP, Host is the computer to look at for a TCP server. The time outs do not count:
    /// <see cref="DiagnosisOptions.Timeout"/> does.
    /// </param>
    /// <param name="diagnosis">How to look; null for the defaults, which take 10 s at most and 2 s where frames arrive.</param>
    /// <param name="progress">Told every step as it ends, on a pool thread, one at a time; what it throws ends the diagnosis.</param>
    /// <param name="cancellationToken">Ends the diagnosis with an <see cref="OperationCanceledException"/>.</param>
    /// <returns>What was found. Whatever the network does is a result, never an exception.</returns>
    /// <exception cref="ArgumentException">An option is out of its range; the message names it.</exception>
    public static Task<StreamDiagnosis> DiagnoseAsync(
        NeuronReaderOptions options,
        DiagnosisOptions? diagnosis = null,
        IProgress<DiagnosisStep>? progress = null,
        CancellationToken cancellationToken = default)
    {
        ArgumentNullException.ThrowIfNull(options);
        DiagnosisOptions how = diagnosis?.Copy() ?? new DiagnosisOptions();
        if (options.FindFault() is { } fault)
            throw new ArgumentException(fault, nameof(options));
        if (how.FindFault() is { } howFault)
            throw new ArgumentException(howFault, nameof(diagnosis));

        NeuronReaderOptions copy = options.Copy();
        return Task.Run(() => RunAsync(copy, copy.Link, how, progress, cancellationToken), cancellationToken);
    }

    internal static async Task<StreamDiagnosis> RunAsync(
        NeuronReaderOptions options, LinkOptions link, DiagnosisOptions how, IProgress<DiagnosisStep>? progress, CancellationToken cancellationToken)
    {
        var log = new StepLog(progress);
        var context = new DiagnosisContext(ForDiagnosis(link), how, log, cancellationToken);
        Conclusion conclusion = await ExamineAsync(options, context).ConfigureAwait(false);
        if (options.CalculationLink is { } second)
            conclusion = await CalculationExamination.AddAsync(context, ForDiagnosis(second), conclusion, other => ExamineAsync(options, other)).ConfigureAwait(false);

        IReadOnlyList<ExplainedVerdict> verdicts = conclusion.Verdicts;
        string advice = string.Join(" ", verdicts.Select(static verdict => verdict.Advice).Where(static text => text is not null));
        return new StreamDiagnosis
        {
            Verdicts = [.. verdicts.Select(static verdict => verdict.Verdict)],
            Summary = string.Join(" ", verdicts.Select(static verdict => verdict.Advice is null ? verdict.Text : $"{verdict.Text} {verdict.Advice}")),
            Advice = advice.Length > 0 ? advice : null,
            SampleCode = conclusion.Endpoint is { } endpoint ? SampleProgram.For(options, endpoint, how.Expected) : null,
            Steps = log.Steps,
            Avatars = [.. conclusion.Samples.SelectMany(static sample => sample.Avatars).Select(static avatar => avatar.ToPublic())],
            Elapsed = context.Elapsed,
        };
    }

    private static async Task<Conclusion> ExamineAsync(NeuronReaderOptions options, DiagnosisContext context) => options.Transport == TransportKind.Tcp
        ? await new TcpExamination(context).RunAsync().ConfigureAwait(false)
        : await new UdpExamination(context, options.AllowedSenders).RunAsync().ConfigureAwait(false);

    // The threads that connections share out among them are for readers; a look at a dozen ports is over in a moment.
    private static LinkOptions ForDiagnosis(LinkOptions link) => link with { TakeReceiver = static _ => new BlockingTcpReceiver() };
}
