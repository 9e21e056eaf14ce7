using NeuronMocap.Protocol;

namespace NeuronMocap.Delivery;

// Gives every packet of the receive thread to all consumers. Other threads add and remove consumers by replacing the array.
internal sealed class PacketDispatcher(StreamCounters counters)
{
    private readonly object _lock = new();
    private volatile Place[] _consumers = [];

    // Receive thread. Whether consumers of other threads get packets later, with Show.
    public bool IsHolding { get; set; }

    public void Add(IPacketConsumer consumer)
    {
        lock (_lock)
            _consumers = [.. _consumers, new Place(consumer, consumer as IHoldingConsumer)];
    }

    public void Remove(IPacketConsumer consumer)
    {
        lock (_lock)
            _consumers = [.. _consumers.Where(place => place.Consumer != consumer)];
    }

    // Commands, which do not concern consumers of frames, and packets without values are only counted.
    public void Dispatch(in ReceivedPacket packet)
    {
        counters.Count(packet);
        if (!packet.IsFrame)
            return;

        foreach (Place place in _consumers)
        {
            if (IsHolding && place.Holding is { } holding)
                holding.Hold(packet);
            else
                place.Consumer.OnPacket(packet);
        }
    }

    // Shows what was held. A consumer that was removed meanwhile discards it.
    public void Show()
    {
        foreach (Place place in _consumers)
            place.Holding?.Show();
    }

    public void EndHolding()
    {
        if (!IsHolding)
            return;

        IsHolding = false;
        Show();
    }

    private readonly record struct Place(IPacketConsumer Consumer, IHoldingConsumer? Holding);
}
