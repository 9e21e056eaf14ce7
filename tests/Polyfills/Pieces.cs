using System.Net;
using NeuronMocap.Protocol;
using NeuronMocap.Transport;

namespace NeuronMocap;

// An array is no segment by itself on .NET Framework.
internal static class Pieces
{
    public static void Push(this PacketAssembler assembler, byte[] piece, long timestamp) => assembler.Push(new ArraySegment<byte>(piece), timestamp);

    public static void Push(this UdpSenders senders, SocketAddress address, byte[] datagram, long timestamp) =>
        senders.Push(address, new ArraySegment<byte>(datagram), timestamp);
}
