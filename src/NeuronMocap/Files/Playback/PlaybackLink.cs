using NeuronMocap.Protocol;
using NeuronMocap.Transport;

namespace NeuronMocap.Recording;

// One connection of a playback. The run waits for events, on dedicated threads of the link.
internal sealed class PlaybackLink(PlaybackRun run) : Link
{
    // Never disposed: it has no timer, and the thread may still check it.
    private readonly CancellationTokenSource _closeSource = new();

    public override ReceiveThread ReceiveThread => ReceiveThread.Dedicated;

    public override string Target => run.Target;

    public override Task<LinkEnd> OpenAsync(CancellationToken cancellationToken) => RunAsync(() => run.Open(_closeSource.Token));

    public override Task<LinkEnd> ReceiveAsync(IPacketReceiver receiver, ILinkListener? listener) =>
        RunAsync(() => run.Receive(receiver, listener, _closeSource.Token));

    public override void Close()
    {
        _closeSource.Cancel();
        run.Wake();
    }

    private async Task<LinkEnd> RunAsync(Func<LinkEnd> action)
    {
        LinkEnd end = LinkEnd.Requested;
        await DedicatedThread.RunAsync("NeuronMocap playback", Run, TaskCreationOptions.None).ConfigureAwait(false);
        return _closeSource.IsCancellationRequested ? LinkEnd.Requested : end;

        void Run()
        {
            using TimerResolution resolution = TimerResolution.Raise();
            end = action();
        }
    }
}
