using System.Net.Sockets;
using RabbitMQ.Client;

namespace NeuronMocap.RabbitMq.Connecting;

// The client (7.1) has faults at the start of a connection. If the other end closes within a frame, the client reads the end again and again, and uses a
// whole processor. It also waits without a limit for an answer. Here the end of the bytes is an exception, and a failed attempt closes the socket.
internal sealed class BrokerSocket(AddressFamily family) : TcpClientAdapter(new Socket(family, SocketType.Stream, ProtocolType.Tcp) { NoDelay = true })
{
    public override NetworkStream GetStream() => new BrokerStream(Client!);
}

internal sealed partial class BrokerStream(Socket socket) : NetworkStream(socket)
{
    public override int Read(byte[] buffer, int offset, int count) => Check(base.Read(buffer, offset, count), count);

    private static int Check(int count, int wanted) => count == 0 && wanted > 0 ? throw new EndOfStreamException("The other end closed the connection.") : count;
}
