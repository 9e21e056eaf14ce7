using System.Net.Sockets;

namespace NeuronMocap.Tests.Vendor;

internal static class VendorError
{
    /// <summary>The system's own number of an error, which the functions return.</summary>
    public static int CodeOf(SocketError error) => new SocketException((int)error).ErrorCode;
}
