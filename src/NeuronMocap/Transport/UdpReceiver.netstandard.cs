using System.Diagnostics;
using System.Net;
using System.Net.Sockets;

namespace NeuronMocap.Transport;

internal static class UdpReceiver
{
    private const int MaxDatagram = 65_536;

    // Never completes; throws when the socket is closed or fails.
    public static Task ReceiveAsync(Socket socket, UdpSenders senders) =>
        ReceiveThread.RunAsync("NeuronMocap UDP receive", () => Receive(socket, senders));

    private static void Receive(Socket socket, UdpSenders senders)
    {
        byte[] buffer = new byte[MaxDatagram];
        var sender = new SenderEndPoint(socket.LocalEndPoint!);
        while (true)
        {
            EndPoint remote = sender;
            int count = socket.ReceiveFrom(buffer, 0, buffer.Length, SocketFlags.None, ref remote);
            senders.Push(sender.Address, new ArraySegment<byte>(buffer, 0, count), Stopwatch.GetTimestamp());
        }
    }

    // ReceiveFrom makes a new end point for every datagram unless it is given one that makes itself: this one keeps the address it was
    // given, in the object that the runtime wrote it to.
    private sealed class SenderEndPoint(EndPoint local) : EndPoint
    {
        public SocketAddress Address { get; private set; } = local.Serialize();

        public override AddressFamily AddressFamily => local.AddressFamily;

        public override SocketAddress Serialize() => Address;

        public override EndPoint Create(SocketAddress socketAddress)
        {
            Address = socketAddress;
            return this;
        }
    }
}
