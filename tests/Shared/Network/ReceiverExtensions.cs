using NeuronMocap.Transport;

namespace NeuronMocap.Tests.Network;

internal static class ReceiverExtensions
{
    // A reader of a TCP server that waits as the test says, independent of the number of connections in the process.
    public static NeuronReader CreateReader(this NeuronReaderOptions options, Func<TcpReceiver> takeReceiver) =>
        new(options, () => new TcpLink(options.Link with { TakeReceiver = _ => takeReceiver() }));
}
