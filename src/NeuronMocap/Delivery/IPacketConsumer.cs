using NeuronMocap.Protocol;

namespace NeuronMocap.Delivery;

// One way in which frames reach the application. Called on the receive thread only; must not throw, and must not wait unless the application chose that.
internal interface IPacketConsumer
{
    void OnPacket(in ReceivedPacket packet);
}
