using NeuronMocap.Protocol;

namespace NeuronMocap.Delivery;

// Hands every packet of the receive thread to all consumers. Consumers come and go on other threads, by replacing the array.
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

    // False for a packet that no consumer gets: commands, which the command channel will take, and packets of no values.
    public bool Dispatch(in ReceivedPacket packet)
    {
        if (!Count(packet))
            return false;

        foreach (IPacketConsumer consumer in _consumers)
            consumer.OnPacket(packet);

        return true;
    }

    private bool Count(in ReceivedPacket packet)
    {
        if (packet.Kind == PacketKind.Command)
        {
            counters.CountCommand(packet.Bytes.Count);
            return false;
        }

        if (packet.Bytes.Count == ProtocolConstants.HeaderSize)
        {
            counters.CountEmpty(packet.Bytes.Count);
            return false;
        }

        if (packet.Kind == PacketKind.Motion)
            counters.CountFrame(packet, MotionHeader.Read(packet.Bytes));
        else
            counters.CountFrame(packet, CalculationHeader.Read(packet.Bytes));

        return true;
    }
}
