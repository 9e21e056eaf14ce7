using System.Net;

namespace NeuronMocap.Transport;

// Every datagram passes here, so the bytes are compared as a whole.
internal sealed partial class SenderComparer
{
    public bool Equals(SocketAddress? x, SocketAddress? y) =>
        x is null || y is null ? ReferenceEquals(x, y) : BytesOf(x).SequenceEqual(BytesOf(y));

    public int GetHashCode(SocketAddress address)
    {
        var hash = new HashCode();
        hash.AddBytes(BytesOf(address));
        return hash.ToHashCode();
    }

    private static ReadOnlySpan<byte> BytesOf(SocketAddress address) => address.Buffer.Span[..address.Size];
}
