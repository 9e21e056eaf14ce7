using System.Net;
using NeuronMocap.Transport;

namespace NeuronMocap.Tests.Network;

// A host name whose look-up does not end.
internal sealed class UnansweredName
{
    private readonly TaskCompletionSource _asked = new();

    public Task Asked => _asked.Task;

    public NeuronReader CreateReader()
    {
        var options = new LinkOptions("suit-pc", 7001)
        {
            Resolve = _ =>
            {
                _asked.SetResult();
                return new TaskCompletionSource<IPAddress[]>().Task;
            },
        };
        return new NeuronReader(new NeuronReaderOptions(), () => new TcpLink(options));
    }
}
