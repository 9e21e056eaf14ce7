namespace NeuronMocap.Server.Broadcasting;

/// <summary>
/// The newest frames of a paced broadcast, encoded once and read by every client at its own position. This one ring is the bounded queue
/// of all clients: whoever falls behind by more than its length goes on at the oldest frame that is left and is told how many it missed.
/// The writer never waits for a reader, only for the lock, which a reader holds while it copies. A frame may appear packet by packet; a reader's first
/// packet is always the first of a frame.
/// </summary>
/// <param name="length">How many frames are kept, the one that is appearing among them.</param>
/// <param name="packetsPerFrame">Packets of every frame.</param>
internal sealed class FrameLog(int length, int packetsPerFrame = 1)
{
    private readonly object _lock = new();
    private readonly Slot[] _slots = new Slot[length];
    private long _end;
    private bool _isFramePending;
    private bool _isComplete;
    private bool _isAborted;

    /// <summary>Makes a reader's place: at the next frame to be published.</summary>
    public FrameCursor CreateCursor()
    {
        lock (_lock)
            return FrameCursor.At(_end);
    }

    /// <summary>Adds a frame; the oldest gives way when the ring is full.</summary>
    /// <param name="frame">Exactly one frame; copied.</param>
    public void Publish(ReadOnlySpan<byte> frame) => Publish(frame, packetsPerFrame);

    /// <summary>Adds the next packets of a frame; with the last of them the frame is complete, and the next call begins another.</summary>
    /// <param name="bytes">The packets; copied.</param>
    /// <param name="packets">How many they are.</param>
    public void Publish(ReadOnlySpan<byte> bytes, int packets)
    {
        lock (_lock)
        {
            ref Slot slot = ref _slots[_end % _slots.Length];
            if (!_isFramePending)
                slot.Clear();

            slot.Append(bytes, packets);
            _isFramePending = slot.Packets < packetsPerFrame;
            if (!_isFramePending)
                _end++;

            Monitor.PulseAll(_lock);
        }
    }

    /// <summary>Says that no frame will follow; readers still get those that are there.</summary>
    public void Complete()
    {
        lock (_lock)
        {
            _isComplete = true;
            Monitor.PulseAll(_lock);
        }
    }

    /// <summary>Sends all readers away at once.</summary>
    public void Abort()
    {
        lock (_lock)
        {
            _isAborted = true;
            Monitor.PulseAll(_lock);
        }
    }

    /// <summary>Ends the wait of one reader, this one or else its next.</summary>
    /// <param name="cursor">The reader's place.</param>
    public void Wake(FrameCursor cursor)
    {
        lock (_lock)
        {
            cursor.IsWoken = true;
            Monitor.PulseAll(_lock);
        }
    }

    /// <summary>Waits for packets and copies as many as are there and fit.</summary>
    /// <param name="cursor">The reader's place; moved past what was copied and missed.</param>
    /// <param name="destination">Room for at least one frame.</param>
    /// <param name="maxFrames">Not more than these.</param>
    /// <returns>What was copied; nothing after <see cref="Wake"/>, after the end and after <see cref="Abort"/>.</returns>
    public FrameBatch Read(FrameCursor cursor, Span<byte> destination, int maxFrames = int.MaxValue)
    {
        lock (_lock)
        {
            while (!HasMore(cursor) && !_isComplete && !_isAborted && !cursor.IsWoken)
                Monitor.Wait(_lock);

            cursor.IsWoken = false;
            long missed = CountOverwritten(cursor);
            if (missed > 0)
                cursor.Skip(Oldest, missed);

            int first = cursor.Packets;
            int bytes = 0;
            int packets = 0;
            for (int frame = 0; frame < maxFrames && !_isAborted && HasMore(cursor); frame++)
            {
                Slot slot = _slots[cursor.Position % _slots.Length];
                ReadOnlySpan<byte> rest = slot.Bytes[cursor.Bytes..];
                if (!rest.TryCopyTo(destination[bytes..]))
                    break;

                bytes += rest.Length;
                packets += slot.Packets - cursor.Packets;
                if (cursor.Position < _end)
                    cursor.MoveTo(cursor.Position + 1);
                else
                    cursor.MoveWithin(slot.Bytes.Length, slot.Packets);
            }

            return new FrameBatch(bytes, packets, first);
        }
    }

    /// <summary>Whether a reader has had everything that there will ever be.</summary>
    /// <param name="cursor">The reader's place.</param>
    public bool IsAtEnd(FrameCursor cursor)
    {
        lock (_lock)
            return _isComplete && cursor.Position == _end;
    }

    /// <summary>Whether there will be nothing more for a reader.</summary>
    /// <param name="cursor">The reader's place.</param>
    public bool HasEnded(FrameCursor cursor)
    {
        lock (_lock)
            return _isAborted || (_isComplete && cursor.Position == _end);
    }

    /// <summary>
    /// How many packets a reader has lost so far. One that is stuck in a write does not read: what it has lost meanwhile is counted here.
    /// </summary>
    /// <param name="cursor">The reader's place.</param>
    public long GetMissed(FrameCursor cursor)
    {
        lock (_lock)
            return cursor.Missed + CountOverwritten(cursor);
    }

    // The first frame that is left.
    private long Oldest => _end + (_isFramePending ? 1 : 0) - _slots.Length;

    private bool HasMore(FrameCursor cursor) =>
        cursor.Position < _end || (_isFramePending && cursor.Packets < _slots[_end % _slots.Length].Packets);

    private long CountOverwritten(FrameCursor cursor) =>
        cursor.Position < Oldest ? ((Oldest - cursor.Position) * packetsPerFrame) - cursor.Packets : 0;

    private struct Slot
    {
        private byte[]? _bytes;
        private int _length;

        public readonly ReadOnlySpan<byte> Bytes => _bytes.AsSpan(0, _length);

        public int Packets { get; private set; }

        public void Clear() => (_length, Packets) = (0, 0);

        // Text frames change their length a little: an eighth more, and the memory is taken once.
        public void Append(ReadOnlySpan<byte> bytes, int packets)
        {
            int length = _length + bytes.Length;
            if (_bytes is null)
                _bytes = new byte[length];
            else if (_bytes.Length < length)
                Array.Resize(ref _bytes, length + (length / 8));

            bytes.CopyTo(_bytes.AsSpan(_length));
            _length = length;
            Packets += packets;
        }
    }
}
