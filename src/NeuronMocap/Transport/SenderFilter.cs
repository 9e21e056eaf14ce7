using System.Net;
using System.Net.Sockets;

namespace NeuronMocap.Transport;

// The senders that may send datagrams to the reader, and those that were refused. The receive loop writes, any thread reads.
internal sealed class SenderFilter(IReadOnlyList<IPAddress> allowed)
{
    // Thousands of addresses can be forged. The first few are enough to recognize a forgotten setting.
    private const int MaxNames = 4;

    private readonly byte[][] _allowed = [.. allowed.Select(static address => Normalize(address).GetAddressBytes())];
    private volatile byte[][] _refused = [];
    private long _refusedDatagrams;

    public long RefusedDatagrams => Volatile.Read(ref _refusedDatagrams);

    // The first four addresses that were refused.
    public IEnumerable<IPAddress> RefusedSenders => _refused.Select(static address => new IPAddress(address));

    // Allocates nothing. The reader never answers a refused sender.
    public bool Allows(SocketAddress sender) => _allowed.Length == 0 || Contains(_allowed, sender);

    public void CountRefused(SocketAddress sender)
    {
        Volatile.Write(ref _refusedDatagrams, _refusedDatagrams + 1);
        if (_refused.Length < MaxNames && !Contains(_refused, sender))
            _refused = [.. _refused, Copy(sender)];
    }

    // Returns the place of the address in the system's structure: after the port, and for IPv6 also after the flow.
    public static (int Offset, int Length) Locate(SocketAddress address) =>
        address.Family == AddressFamily.InterNetworkV6 ? (8, 16) : (4, 4);

    private static bool Contains(byte[][] addresses, SocketAddress sender)
    {
        (int offset, int length) = Locate(sender);
        foreach (byte[] address in addresses)
        {
            if (address.Length != length)
                continue;

            int same = 0;
            while (same < length && address[same] == sender[offset + same])
                same++;

            if (same == length)
                return true;
        }

        return false;
    }

    private static byte[] Copy(SocketAddress sender)
    {
        (int offset, int length) = Locate(sender);
        byte[] address = new byte[length];
        for (int i = 0; i < length; i++)
            address[i] = sender[offset + i];

        return address;
    }

    private static IPAddress Normalize(IPAddress address) => address.IsIPv4MappedToIPv6 ? address.MapToIPv4() : address;
}
