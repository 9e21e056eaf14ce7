using System.Net;
using NeuronMocap.Transport;

namespace NeuronMocap.Tests.Network;

// A host name whose look-up does not end.
internal sealed class UnansweredName
{
    private readonly TaskCompletionSource _asked = new(TaskCreationOptions.RunContinuationsAsynchronously);

    public Task Asked => _asked.Task;

    public NeuronReader CreateReader()
    {
        var options = new LinkOptions("suit-pc", 7001)
        {
            Resolve = _ =>
            {
                _asked.TrySetResult();
                return new TaskCompletionSource<IPAddress[]>().Task;
            },
        };
        return new NeuronReader(new NeuronReaderOptions { StopTimeout = Limits.Unexpected }, () => new TcpLink(options));
    }
}
