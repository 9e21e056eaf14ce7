using NeuronMocap.Protocol;

namespace NeuronMocap.Delivery;

// One way in which frames reach the application. Called on the receive thread only; must not wait and must not throw.
internal interface IPacketConsumer
{
    void OnPacket(in ReceivedPacket packet);
}
