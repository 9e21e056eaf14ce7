using System.Diagnostics;
using System.Net;
using System.Net.Sockets;

namespace NeuronMocap.Tests.Network;

internal static class FreePort
{
    private const int First = 20_000;
    private const int Count = 12_000;

    // Test programs that run side by side start far from each other.
    private static int _last = (int)(Stopwatch.GetTimestamp() % Count);

    /// <summary>A port that is free for TCP and UDP on all addresses.</summary>
    public static int Next()
    {
        while (true)
        {
            int port = Candidate();
            if (IsFree(SocketType.Stream, ProtocolType.Tcp, port) && IsFree(SocketType.Dgram, ProtocolType.Udp, port))
                return port;
        }
    }

    /// <summary>A port that may be in use.</summary>
    /// <remarks>
    /// Systems assign ports automatically from 32768 (Linux) or 49152 (Windows, macOS) up. This one is below, so that no other test gets it before its
    /// owner opens it.
    /// </remarks>
    public static int Candidate() => First + (Interlocked.Increment(ref _last) % Count);

    private static bool IsFree(SocketType type, ProtocolType protocol, int port)
    {
        using var socket = new Socket(AddressFamily.InterNetwork, type, protocol);
        try
        {
            socket.Bind(new IPEndPoint(IPAddress.Any, port));
            return true;
        }
        catch (SocketException)
        {
            return false;
        }
    }
}
