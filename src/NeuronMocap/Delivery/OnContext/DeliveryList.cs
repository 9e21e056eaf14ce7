namespace NeuronMocap.Delivery;

// The open deliveries of a reader. Any thread.
internal sealed class DeliveryList
{
    private readonly object _lock = new();
    private readonly List<FrameDelivery> _open = [];
    private bool _hasEnded;

    public void Add(FrameDelivery delivery)
    {
        lock (_lock)
        {
            if (!_hasEnded)
            {
                _open.Add(delivery);
                return;
            }
        }

        delivery.OnReaderStopped();
    }

    public void Remove(FrameDelivery delivery)
    {
        lock (_lock)
            _open.Remove(delivery);
    }

    // The reader was disposed. No lock is held while a delivery ends.
    public void EndAll()
    {
        FrameDelivery[] open;
        lock (_lock)
        {
            _hasEnded = true;
            open = [.. _open];
        }

        foreach (FrameDelivery delivery in open)
            delivery.OnReaderStopped();
    }
}
