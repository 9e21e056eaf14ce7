using System.Net;
using System.Net.Sockets;

namespace NeuronMocap.Transport;

// The port on which datagrams are received, by a reader and by a diagnosis alike.
internal static class UdpSocket
{
    // Room for a burst of frames while the receive thread is busy: about half a second of 100 avatars at 60 Hz.
    public const int WantedBuffer = 4 * 1024 * 1024;

    // Not asked of the framework, which has no one way for both builds.
    public static readonly bool IsLinux = Environment.OSVersion.Platform == PlatformID.Unix && Directory.Exists("/proc/self");

    // Throws SocketException.
    public static Socket Open(LinkOptions options)
    {
        IPAddress address = options.LocalAddress ?? IPAddress.Any;
        var socket = new Socket(address.AddressFamily, SocketType.Dgram, ProtocolType.Udp);
        try
        {
            AskForBuffer(socket);
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

    // What the system gave of WantedBuffer; null where it does not say. Linux tells twice as much, with what it needs for its own records.
    public static int? ReadBuffer(Socket socket)
    {
        try
        {
            return IsLinux ? socket.ReceiveBufferSize / 2 : socket.ReceiveBufferSize;
        }
        catch (SocketException)
        {
            return null;
        }
    }

    // Linux cuts the size down to its limit, macOS refuses one above it: the port works with the system's own size, too.
    private static void AskForBuffer(Socket socket)
    {
        try
        {
            socket.ReceiveBufferSize = WantedBuffer;
        }
        catch (SocketException)
        {
            // The status tells what there is.
        }
    }
}
