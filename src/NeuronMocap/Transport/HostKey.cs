using System.Net;

namespace NeuronMocap.Transport;

// The computer of an address, regardless of the port, as numbers that are fast to compare.
internal readonly record struct HostKey(ulong First, ulong Second)
{
    public static HostKey Of(SocketAddress address)
    {
        (int offset, int length) = SenderFilter.Locate(address);
        ulong first = 0;
        ulong second = (ulong)length;
        for (int i = 0; i < length; i++)
            (first, second) = ((first << 8) | address[offset + i], i < 8 ? second : (second << 8) | (byte)(first >> 56));

        return new HostKey(first, second);
    }
}
