using NeuronMocap.Transport;

namespace NeuronMocap.Diagnostics;

// What arrives on an open link: for as long as bytes may take to begin, and then for as long as their measuring takes. The link is closed afterwards.
internal sealed record LinkSample(StreamSample Sample, TimeSpan Silence, bool HasEnded, LinkEnd End)
{
    public static async Task<LinkSample> TakeAsync(DiagnosisContext context, Link link)
    {
        var sample = new StreamSample(context.Expected);
        Task<LinkEnd> receiving = link.ReceiveAsync(sample, listener: null);
        TimeSpan silence = context.Share(context.Budget.Silence);
        await context.WaitAsync(silence, sample.Started, receiving).ConfigureAwait(false);
        if (sample.Started.IsCompleted)
            await context.WaitAsync(context.Share(context.Budget.Measuring), receiving).ConfigureAwait(false);

        bool hasEnded = receiving.IsCompleted;
        link.Close();
        return new LinkSample(sample, silence, hasEnded, await receiving.ConfigureAwait(false));
    }
}
