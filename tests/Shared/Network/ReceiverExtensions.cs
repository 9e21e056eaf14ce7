using NeuronMocap.Transport;

namespace NeuronMocap.Tests.Network;

internal static class ReceiverExtensions
{
    // A reader of a TCP server that waits as the test says, not as the number of the process's connections has it.
    public static NeuronReader CreateReader(this NeuronReaderOptions options, Func<TcpReceiver> takeReceiver) =>
        new(options, () => new TcpLink(options.Link with { TakeReceiver = _ => takeReceiver() }));
}
