using NeuronMocap.Protocol;
using NeuronMocap.Transport;

namespace NeuronMocap.Recording;

// One connection of a playback. The player is what waits, on threads of the link's own.
internal sealed class PlaybackLink(RecordingPlayer player) : Link
{
    private volatile bool _isClosed;

    public override ReceiveThread ReceiveThread => ReceiveThread.Dedicated;

    public override string Target => player.Target;

    public bool IsClosed => _isClosed;

    public override Task<LinkEnd> OpenAsync(CancellationToken stop) => RunAsync(run => run.Open(this));

    public override Task<LinkEnd> ReceiveAsync(IPacketReceiver receiver) => RunAsync(run => run.Receive(this, receiver));

    public override void Close()
    {
        _isClosed = true;
        player.Control.Wake();
    }

    private async Task<LinkEnd> RunAsync(Func<PlaybackRun, LinkEnd> action)
    {
        LinkEnd end = LinkEnd.Requested;
        await DedicatedThread.RunAsync("NeuronMocap playback", Run, TaskCreationOptions.None).ConfigureAwait(false);
        return _isClosed ? LinkEnd.Requested : end;

        void Run()
        {
            using TimerResolution resolution = TimerResolution.Raise();
            end = player.Run(action);
        }
    }
}
