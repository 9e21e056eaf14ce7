using System.Diagnostics;
using NeuronMocap.Frames;
using NeuronMocap.Protocol;

namespace NeuronMocap.Delivery;

// The newest frame of every avatar. A pass delivers what is new of all avatars, in order of their appearance, so their rates are the same. The memory
// ordering of each frame is that of LatestPacket; the array of slots is replaced and never changed.
internal sealed class NewestSource(FrameFormat format, double maxRate, IDurationRecorder? handOver) : IDeliverySource
{
    private readonly long _interval = maxRate > 0 ? (long)(Stopwatch.Frequency / maxRate) : 0;
    private readonly FramePool _frames = new(format, FramePool.OfHandlers);
    private readonly Slot?[] _places = new Slot?[((int)PacketKind.StudioCalculation + 1) * LatestFrames.MaxAvatars];
    private volatile Slot[] _slots = [];
    private long _delivered;
    private long _dropped;
    private long _replaced;

    // The pass: the slot to look at next, whether it has delivered anything, and the earliest time of the next pass.
    private int _next;
    private bool _hasDelivered;
    private long _passStart;
    private long _due;

    public long Delivered => Volatile.Read(ref _delivered);

    public long Dropped => Volatile.Read(ref _dropped);

    public long Skipped => 0;

    public long Replaced => Volatile.Read(ref _replaced);

    public int Pending
    {
        get
        {
            int pending = 0;
            foreach (Slot slot in _slots)
                pending += slot.Newest.IsFresh ? 1 : 0;

            return pending;
        }
    }

    public bool Add(in ReceivedPacket packet)
    {
        uint avatarIndex = packet.AvatarIndex;
        if (avatarIndex >= LatestFrames.MaxAvatars)
        {
            Volatile.Write(ref _dropped, _dropped + 1);
            return false;
        }

        ref Slot? place = ref _places[((int)packet.Kind * LatestFrames.MaxAvatars) + (int)avatarIndex];
        if (place is { } slot)
        {
            if (slot.Newest.Publish(packet))
                Volatile.Write(ref _replaced, _replaced + 1);
            return true;
        }

        place = new Slot(packet.Length);
        place.Newest.Publish(packet);
        _slots = [.. _slots, place];
        return true;
    }

    public bool TryDeliver(FrameDelivery delivery, long now)
    {
        if (_next == 0)
        {
            if (now < _due)
                return false;

            _passStart = now;
        }

        Slot[] slots = _slots;
        while (_next < slots.Length)
        {
            if (!slots[_next++].Newest.TryTake(out ReceivedPacket packet))
                continue;

            _hasDelivered = true;
            Volatile.Write(ref _delivered, _delivered + 1);
            Deliver(delivery, packet);
            return true;
        }

        EndPass();
        return false;
    }

    public bool TryGetDue(out long due)
    {
        due = _next == 0 ? _due : 0;
        foreach (Slot slot in _slots)
        {
            if (slot.Newest.IsFresh)
                return true;
        }

        return false;
    }

    public void Dispose()
    {
    }

    private void Deliver(FrameDelivery delivery, in ReceivedPacket packet)
    {
        if (handOver is { IsEnabled: true })
            handOver.Record(packet.Kind, Stopwatch.GetTimestamp() - packet.Timestamp);

        AvatarFrame frame = _frames.Lend(packet);
        try
        {
            delivery.Invoke(frame);
        }
        finally
        {
            frame.Expire();
        }
    }

    // Passes keep to a schedule: a pass that begins late does not delay the next one, so the average rate is the one that was asked for.
    private void EndPass()
    {
        _next = 0;
        if (!_hasDelivered)
            return;

        _hasDelivered = false;
        _due = (_passStart - _due < _interval ? _due : _passStart) + _interval;
    }

    private sealed class Slot(int packetSize)
    {
        public LatestPacket Newest { get; } = new(packetSize);
    }
}
