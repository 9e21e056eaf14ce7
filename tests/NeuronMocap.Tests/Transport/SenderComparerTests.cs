using System.Net;
using System.Net.Sockets;
using NeuronMocap.Transport;

namespace NeuronMocap.Tests.Transport;

public sealed class SenderComparerTests
{
    // Mono's addresses have 8 bytes, and the runtime numbers them. Neither may matter.
    [Fact]
    public void Addresses_compare_by_bytes()
    {
        SocketAddress[] addresses = [Address(8, 1, 5000), Address(8, 2, 5000), Address(8, 1, 5001), Address(16, 1, 5000), new IPEndPoint(IPAddress.IPv6Loopback, 5000).Serialize()];
        foreach (SocketAddress address in addresses)
        {
            var copy = new SocketAddress(address.Family, address.Size);
            for (int i = 0; i < address.Size; i++)
                copy[i] = address[i];

            Assert.Equal([address], addresses.Where(other => SenderComparer.Instance.Equals(other, copy)));
            Assert.Equal(SenderComparer.Instance.GetHashCode(address), SenderComparer.Instance.GetHashCode(copy));
        }

        Assert.Equal(addresses.Length, addresses.Select(SenderComparer.Instance.GetHashCode).Distinct().Count());
    }

    private static SocketAddress Address(int size, byte host, ushort port)
    {
        var address = new SocketAddress(AddressFamily.InterNetwork, size);
        (address[2], address[3]) = ((byte)(port >> 8), (byte)port);
        (address[4], address[7]) = (127, host);
        return address;
    }
}
