using System.Net;
using System.Net.Sockets;

namespace NeuronMocap.Transport;

// The port on which datagrams are received, by a reader and by a diagnosis alike.
internal static class UdpSocket
{
    // Room for a burst of frames while the receive thread is busy: about half a second of 100 avatars at 60 Hz.
    private const int BufferSize = 4 * 1024 * 1024;

    // Throws SocketException.
    public static Socket Open(LinkOptions options)
    {
        IPAddress address = options.LocalAddress ?? IPAddress.Any;
        var socket = new Socket(address.AddressFamily, SocketType.Dgram, ProtocolType.Udp);
        try
        {
            socket.ReceiveBufferSize = BufferSize;
            if (options.SharePort)
                socket.SetSocketOption(SocketOptionLevel.Socket, SocketOptionName.ReuseAddress, optionValue: true);

            socket.Bind(new IPEndPoint(address, options.Port));
            return socket;
        }
        catch (SocketException)
        {
            socket.Dispose();
            throw;
        }
    }
}
