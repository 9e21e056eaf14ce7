using NeuronMocap.Diagnostics;
using NeuronMocap.Reader;
using NeuronMocap.Transport;

namespace NeuronMocap;

/// <summary>
/// Finds out why a reader receives no data. It checks every step from the server's name to the frame rate. It reports which step fails, and which
/// setting of Axis Neuron or Axis Studio to change.
/// </summary>
public static class NeuronDiagnostics
{
    /// <summary>
    /// Receives as a reader with these options would, and examines what arrives. If nothing arrives, it looks at other ports and transports.
    /// </summary>
    /// <remarks>
    /// The diagnosis makes its own connections and does not use those of a reader. Over UDP it binds the port. Stop a reader of the same port first, or
    /// let it share the port. While a diagnosis runs on a shared port, it takes the unicast datagrams; the reader does not get them. A
    /// <see cref="NeuronReaderOptions.Source"/> is opened once more. A stream or pipe that is already open cannot be diagnosed: its bytes would be lost to
    /// the reader.
    /// </remarks>
    /// <param name="options">
    /// The options of the reader that receives no data. Over UDP, Host is the computer on which to look for a TCP server. The timeouts of these options
    /// are ignored; <see cref="DiagnosisOptions.Timeout"/> applies instead.
    /// </param>
    /// <param name="diagnosis">Options of the diagnosis. Null for the defaults, which take at most 10 s, and 2 s if frames arrive.</param>
    /// <param name="progress">
    /// Receives every step when it ends, on a pool thread, one at a time. An exception from it ends the diagnosis. May be null.
    /// </param>
    /// <param name="cancellationToken">Ends the diagnosis with an <see cref="OperationCanceledException"/>.</param>
    /// <returns>The result. A network problem is part of the result, never an exception.</returns>
    /// <exception cref="ArgumentException">An option is out of range; the message names it.</exception>
    public static Task<StreamDiagnosis> DiagnoseAsync(
        NeuronReaderOptions options,
        DiagnosisOptions? diagnosis = null,
        IProgress<DiagnosisStep>? progress = null,
        CancellationToken cancellationToken = default)
    {
        ArgumentNullException.ThrowIfNull(options);
        DiagnosisOptions how = diagnosis?.Copy() ?? new DiagnosisOptions();
        NeuronReaderOptions copy = options.Copy();
        if (copy.FindFault() is { } fault)
            throw new ArgumentException(fault, nameof(options));
        if (how.FindFault() is { } howFault)
            throw new ArgumentException(howFault, nameof(diagnosis));

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
            SampleCode = conclusion.Endpoint is { Source: null } endpoint ? SampleProgram.For(options, endpoint, how.Expected) : null,
            Steps = log.Steps,
            Avatars = [.. conclusion.Samples.SelectMany(static sample => sample.Avatars).Select(static avatar => avatar.ToPublic())],
            Elapsed = context.Elapsed,
        };
    }

    private static Task<Conclusion> ExamineAsync(NeuronReaderOptions options, DiagnosisContext context) => (options.Source, options.Transport) switch
    {
        ({ } source, _) => new SourceExamination(context, source, options.Target).RunAsync(),
        (_, TransportKind.Tcp) => new TcpExamination(context).RunAsync(),
        _ => new UdpExamination(context, options.AllowedSenders).RunAsync(),
    };

    // The threads that connections share are for readers. The diagnosis of a dozen ports is short, so it uses its own threads.
    private static LinkOptions ForDiagnosis(LinkOptions link) => link with { TakeReceiver = static _ => new BlockingTcpReceiver() };
}
