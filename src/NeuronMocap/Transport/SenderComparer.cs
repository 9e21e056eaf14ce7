using System.Net;

namespace NeuronMocap.Transport;

// Compares addresses by their bytes. SocketAddress also does this, but has a fault on Mono, and therefore in Unity. There, an address that the system
// filled in has the hash code zero, but its copy has another.
internal sealed partial class SenderComparer : IEqualityComparer<SocketAddress>
{
    public static SenderComparer Instance { get; } = new();
}
