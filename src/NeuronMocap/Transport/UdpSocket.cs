using System.Net;
using System.Net.Sockets;
using System.Runtime.InteropServices;

namespace NeuronMocap.Transport;

// The port that receives datagrams, for a reader or a diagnosis.
internal static class UdpSocket
{
    // Room for a burst of frames while the receive thread is busy: about half a second of 100 avatars at 60 Hz.
    public const int WantedBuffer = 4 * 1024 * 1024;

    // Not read from the framework, which has no common way for all builds.
    public static readonly bool IsLinux = Environment.OSVersion.Platform == PlatformID.Unix && Directory.Exists("/proc/self");

    // The setting of the system that limits the buffer, with a value that suffices; null if the system has none. macOS subtracts its own overhead.
    public static readonly string? BufferSetting = IsLinux ? FormattableString.Invariant($"net.core.rmem_max={WantedBuffer}")
        : OperatingSystem.IsMacOS() ? FormattableString.Invariant($"kern.ipc.maxsockbuf={2 * WantedBuffer}")
        : null;

    // Throws SocketException.
    public static Socket Open(LinkOptions options)
    {
        IPAddress address = options.LocalAddress ?? IPAddress.Any;
        var socket = new Socket(address.AddressFamily, SocketType.Dgram, ProtocolType.Udp);
        try
        {
            AskForBuffer(socket);

            // Set in either case: Mono shares every port of UDP unless told otherwise.
            socket.SetSocketOption(SocketOptionLevel.Socket, SocketOptionName.ReuseAddress, options.SharePort);
            socket.Bind(new IPEndPoint(address, options.Port));
            return socket;
        }
        catch (SocketException)
        {
            socket.Dispose();
            throw;
        }
    }

    private static readonly bool IsDotNet = RuntimeInformation.FrameworkDescription.StartsWith(".NET ", StringComparison.Ordinal);

    // The part of WantedBuffer that the system granted; null if it is unknown. Linux reports twice the size, which includes its own overhead. Mono has
    // halved it.
    public static int? ReadBuffer(Socket socket)
    {
        try
        {
            return IsLinux && IsDotNet ? socket.ReceiveBufferSize / 2 : socket.ReceiveBufferSize;
        }
        catch (SocketException)
        {
            return null;
        }
    }

    // Linux reduces the size to its limit, and macOS rejects a larger one. The port also works with the system's default size.
    private static void AskForBuffer(Socket socket)
    {
        try
        {
            socket.ReceiveBufferSize = WantedBuffer;
        }
        catch (SocketException)
        {
            // The status reports the actual size.
        }
    }
}
