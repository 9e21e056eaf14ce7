using NeuronMocap.Delivery;

namespace NeuronMocap.AspNetCore;

/// <summary>The newest messages of each avatar for one client. The broadcaster puts messages in, and the client's loop takes them out.</summary>
/// <remarks>
/// Frames often arrive a few at a time, so a few may wait. If there are more, the oldest of the same avatar is dropped and counted. No avatar is left out for
/// another. Thread-safe.
/// </remarks>
/// <param name="depth">Largest number of messages that wait for each avatar and kind.</param>
/// <param name="maxRate">Frames per second of each avatar and kind; 0 for all.</param>
internal sealed class Mailbox(int depth, double maxRate = 0)
{
    // A sender can invent avatar numbers. Further ones are dropped.
    private const int MaxSlots = 1024;

    private readonly object _lock = new();
    private readonly Dictionary<(int Sender, int Avatar, PacketKind Kind), Slot> _slots = [];

    // The slot of each message that waits, in order.
    private readonly Queue<Slot> _waiting = new();
    private long _dropped;
    private long _skipped;
    private bool _isClosed;

    // Messages that were too old, or not sent at the end.
    public long Dropped => Volatile.Read(ref _dropped);

    // Messages that the rate left out.
    public long Skipped => Volatile.Read(ref _skipped);

    // Returns whether the client's loop has something to do.
    public bool Put(MotionMessage message)
    {
        lock (_lock)
        {
            if (_isClosed)
                return false;
            if (Find(message) is not { } slot)
            {
                _dropped++;
                return false;
            }

            if (slot.Schedule is { } schedule && !(message.FrameIndex is { } index ? schedule.Decide(index, message.Timestamp) : schedule.Decide(message.Timestamp)))
            {
                _skipped++;
                return false;
            }

            message.AddReference();
            slot.Messages.Enqueue(message);
            if (slot.Messages.Count <= depth)
            {
                _waiting.Enqueue(slot);
            }
            else
            {
                slot.Messages.Dequeue().Release();
                _dropped++;
            }

            return true;
        }
    }

    // The caller releases the message, and sends the skeleton before it unless it is null.
    public bool TryTake(out MotionMessage? message, out byte[]? skeleton)
    {
        lock (_lock)
        {
            (message, skeleton) = (null, null);
            if (!_waiting.TryDequeue(out Slot? slot))
                return false;

            message = slot.Messages.Dequeue();
            if (message.Skeleton is { } wanted && wanted != slot.Skeleton)
                slot.Skeleton = skeleton = wanted;

            return true;
        }
    }

    public void CountUnsent() => Interlocked.Increment(ref _dropped);

    // Whatever waits is dropped.
    public void Close()
    {
        lock (_lock)
        {
            _isClosed = true;
            while (_waiting.TryDequeue(out Slot? slot))
            {
                slot.Messages.Dequeue().Release();
                _dropped++;
            }
        }
    }

    private Slot? Find(MotionMessage message)
    {
        if (_slots.TryGetValue(message.Key, out Slot? slot) || _slots.Count == MaxSlots)
            return slot;

        slot = new Slot { Schedule = maxRate > 0 ? new ThinningSchedule(new FrameThinning(maxRate, 1)) : null };
        _slots.Add(message.Key, slot);
        return slot;
    }

    private sealed class Slot
    {
        public ThinningSchedule? Schedule { get; init; }

        public Queue<MotionMessage> Messages { get; } = new();

        // The skeleton that the client knows.
        public byte[]? Skeleton { get; set; }
    }
}
