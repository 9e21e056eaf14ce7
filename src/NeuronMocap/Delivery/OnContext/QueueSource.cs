using NeuronMocap.Protocol;

namespace NeuronMocap.Delivery;

// Every frame, in order.
internal sealed class QueueSource(FrameQueue queue) : IDeliverySource
{
    public long Delivered => queue.Delivered;

    public long Dropped => queue.Dropped;

    public long Skipped => queue.Skipped;

    public long Replaced => 0;

    public int Pending => queue.Count;

    public bool Add(in ReceivedPacket packet)
    {
        ((IPacketConsumer)queue).OnPacket(packet);
        return queue.Count > 0;
    }

    public bool TryDeliver(FrameDelivery delivery, long now) =>
        queue.Pump<AvatarFrame, FrameDelivery>(delivery, static (delivery, frame) => delivery.Invoke(frame), maxFrames: 1) == 1;

    public bool TryGetDue(out long due)
    {
        due = 0;
        return queue.Count > 0;
    }

    public void Dispose() => queue.Dispose();
}
