using System.Net;
using System.Net.Sockets;

namespace NeuronMocap.Transport;

// Who may send datagrams to the reader, and who tried without being allowed. The receive loop writes, anyone reads.
internal sealed class SenderFilter(IReadOnlyList<IPAddress> allowed)
{
    // Anyone can forge thousands of addresses; the first few are enough to recognise a setting that was forgotten.
    private const int MaxNames = 4;

    private readonly byte[][] _allowed = [.. allowed.Select(static address => Normalise(address).GetAddressBytes())];
    private volatile byte[][] _refused = [];
    private long _refusedDatagrams;

    public long RefusedDatagrams => Volatile.Read(ref _refusedDatagrams);

    // Addresses that were refused, the first four.
    public IEnumerable<IPAddress> RefusedSenders => _refused.Select(static address => new IPAddress(address));

    // Allocates nothing, and nothing is sent to a sender that is refused.
    public bool Allows(SocketAddress sender) => _allowed.Length == 0 || Contains(_allowed, sender);

    public void CountRefused(SocketAddress sender)
    {
        Volatile.Write(ref _refusedDatagrams, _refusedDatagrams + 1);
        if (_refused.Length < MaxNames && !Contains(_refused, sender))
            _refused = [.. _refused, Copy(sender)];
    }

    // Where the address lies in the system's structure: behind the port, and for IPv6 behind the flow too.
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

    private static IPAddress Normalise(IPAddress address) => address.IsIPv4MappedToIPv6 ? address.MapToIPv4() : address;
}
