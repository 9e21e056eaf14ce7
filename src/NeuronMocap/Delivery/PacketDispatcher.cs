using NeuronMocap.Protocol;

namespace NeuronMocap.Delivery;

// Gives every packet of the receive thread to all consumers. Other threads add and remove consumers by replacing the array.
internal sealed class PacketDispatcher(StreamCounters counters)
{
    private readonly object _lock = new();
    private volatile IPacketConsumer[] _consumers = [];

    public void Add(IPacketConsumer consumer)
    {
        lock (_lock)
            _consumers = [.. _consumers, consumer];
    }

    public void Remove(IPacketConsumer consumer)
    {
        lock (_lock)
            _consumers = [.. _consumers.Where(other => other != consumer)];
    }

    // Commands, which do not concern consumers of frames, and packets without values are only counted.
    public void Dispatch(in ReceivedPacket packet)
    {
        if (!packet.IsFrame)
        {
            counters.CountPassedOver(packet);
            return;
        }

        counters.CountFrame(packet);
        foreach (IPacketConsumer consumer in _consumers)
            consumer.OnPacket(packet);
    }
}
