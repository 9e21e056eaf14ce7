using NeuronMocap.Protocol;

namespace NeuronMocap.Delivery;

// A consumer on another thread. Frames that arrived together can be shown to it together: its thread is then woken once, and the two threads exchange
// their indices once.
internal interface IHoldingConsumer : IPacketConsumer
{
    // Takes the packet; its thread may see it from now on, and sees it after Show.
    void Hold(in ReceivedPacket packet);

    void Show();
}
