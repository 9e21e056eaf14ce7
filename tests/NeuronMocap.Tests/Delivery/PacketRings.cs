using NeuronMocap.Delivery;
using NeuronMocap.Protocol;

namespace NeuronMocap.Tests.Delivery;

internal static class PacketRings
{
    public static bool TryStoreAndPublish(this PacketRing ring, in ReceivedPacket packet)
    {
        bool isStored = ring.TryStore(packet);
        ring.Publish();
        return isStored;
    }
}
