using NeuronMocap.Protocol;

namespace NeuronMocap.Delivery;

// The frames that wait for the context.
internal interface IDeliverySource : IDisposable
{
    long Delivered { get; }

    long Dropped { get; }

    long Skipped { get; }

    long Replaced { get; }

    int Pending { get; }

    // Receive thread. Returns false if no frame waits, because this one was skipped or dropped.
    bool Add(in ReceivedPacket packet);

    // Context. Hands one frame to the delivery; returns false if none is due.
    bool TryDeliver(FrameDelivery delivery, long now);

    // Context. Returns false if no frame waits. due: the time from which a frame may be delivered; 0 for now.
    bool TryGetDue(out long due);
}
