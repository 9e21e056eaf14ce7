using System.Net;

namespace NeuronMocap.Transport;

internal sealed partial class SenderComparer
{
    public bool Equals(SocketAddress? x, SocketAddress? y)
    {
        if (x is null || y is null || x.Size != y.Size)
            return ReferenceEquals(x, y);

        int same = 0;
        while (same < x.Size && x[same] == y[same])
            same++;

        return same == x.Size;
    }

    // FNV-1a.
    public int GetHashCode(SocketAddress address)
    {
        uint hash = 2_166_136_261;
        for (int i = 0; i < address.Size; i++)
            hash = (hash ^ address[i]) * 16_777_619;

        return (int)hash;
    }
}
