using NeuronMocap.Transport;

namespace NeuronMocap.Diagnostics;

// Examines each step of a source, from its opening to its frames. There are no other places to search.
internal sealed class SourceExamination(DiagnosisContext context, ByteSource source, string name)
{
    public async Task<Conclusion> RunAsync()
    {
        using var link = new SourceLink(source, name, context.Link);
        TimeSpan limit = context.Share(context.Budget.Connecting);
        Task<LinkEnd> opening = link.OpenAsync(context.CancellationToken);
        await context.WaitAsync(limit, opening).ConfigureAwait(false);
        if (!opening.IsCompleted)
            return NotOpened(DiagnosisVerdict.NoAnswer, $"Opening {link.Target} takes longer than {ConnectionMessages.Seconds(limit)}.");

        LinkEnd opened = await opening.ConfigureAwait(false);
        if (opened.Reason != ConnectionReason.None)
            return NotOpened(VerdictOf(opened.Reason), opened.Message);

        context.Log.Ok("source", $"{link.Target} is open");
        return await ListenAsync(link).ConfigureAwait(false);
    }

    private async Task<Conclusion> ListenAsync(SourceLink link)
    {
        (StreamSample sample, TimeSpan silence, bool hasEnded, LinkEnd end) = await LinkSample.TakeAsync(context, link).ConfigureAwait(false);
        if (sample.Bytes > 0)
        {
            context.Log.Ok("first bytes", $"{sample.FirstBytes}{(hasEnded ? "; then the bytes ended" : string.Empty)}");
            return StreamExamination.Judge(context, sample, new StreamEndpoint(TransportKind.Tcp, string.Empty, 0, link.Target));
        }

        if (hasEnded)
        {
            context.Log.Failed("first bytes", "none: the bytes ended at once");
            return new Conclusion([new ExplainedVerdict(DiagnosisVerdict.ClosedImmediately, end.Message)]);
        }

        context.Log.Failed("first bytes", $"none in {ConnectionMessages.Seconds(silence)}");
        return new Conclusion([new ExplainedVerdict(DiagnosisVerdict.Silent, ConnectionMessages.NoBytes(link.Target, silence))]);
    }

    private Conclusion NotOpened(DiagnosisVerdict verdict, string message)
    {
        context.Log.Failed("source", "not opened");
        return new Conclusion([new ExplainedVerdict(verdict, message)]);
    }

    private static DiagnosisVerdict VerdictOf(ConnectionReason reason) => reason switch
    {
        ConnectionReason.Refused => DiagnosisVerdict.Refused,
        ConnectionReason.TimedOut => DiagnosisVerdict.NoAnswer,
        ConnectionReason.HostNotFound => DiagnosisVerdict.HostNotFound,
        ConnectionReason.Unreachable => DiagnosisVerdict.Unreachable,
        ConnectionReason.AccessDenied => DiagnosisVerdict.AccessDenied,
        _ => DiagnosisVerdict.NetworkError,
    };
}
