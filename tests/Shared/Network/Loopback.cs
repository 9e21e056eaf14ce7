using System.Net;
using System.Net.Sockets;

namespace NeuronMocap.Tests.Network;

// The abilities of this machine's loopback network.
internal static class Loopback
{
    // macOS has only 127.0.0.1. Other systems have all of 127.0.0.0/8.
    public static bool HasManyAddresses { get; } = CanBind(IPAddress.Parse("127.0.77.1"));

    public static bool HasIPv6 { get; } = CanBind(IPAddress.IPv6Loopback);

    public static void NeedManyAddresses() => Assert.SkipUnless(HasManyAddresses, "This system has only one loopback address.");

    public static void NeedIPv6() => Assert.SkipUnless(HasIPv6, "This machine has no IPv6.");

    private static bool CanBind(IPAddress address)
    {
        try
        {
            using var socket = new Socket(address.AddressFamily, SocketType.Dgram, ProtocolType.Udp);
            socket.Bind(new IPEndPoint(address, 0));
            return true;
        }
        catch (SocketException)
        {
            return false;
        }
    }
}
