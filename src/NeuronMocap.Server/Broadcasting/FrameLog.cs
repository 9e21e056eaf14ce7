namespace NeuronMocap.Server.Broadcasting;

/// <summary>A ring of the newest frames of a paced broadcast. Frames are encoded once, and every client reads them at its own position.</summary>
/// <remarks>
/// The ring is the bounded queue of all clients. A client that falls behind by more than its length continues at the oldest frame left and is told
/// how many packets it missed. The writer never waits for a reader; it only waits for the lock, which a reader holds while it copies. A frame may
/// appear packet by packet. The first packet that a reader gets is always the first packet of a frame.
/// </remarks>
/// <param name="length">Number of frames to keep, including the frame that is appearing.</param>
/// <param name="packetsPerFrame">Number of packets in every frame.</param>
internal sealed class FrameLog(int length, int packetsPerFrame = 1)
{
    private readonly object _lock = new();
    private readonly Slot[] _slots = new Slot[length];
    private long _end;
    private bool _isFramePending;
    private bool _isComplete;
    private bool _isAborted;

    /// <summary>Creates the position of a reader, at the next frame to be published.</summary>
    public FrameCursor CreateCursor()
    {
        lock (_lock)
            return FrameCursor.At(_end);
    }

    /// <summary>Adds a frame. The oldest frame is removed when the ring is full.</summary>
    /// <param name="frame">Exactly one frame, which is copied.</param>
    public void Publish(ReadOnlySpan<byte> frame) => Publish(frame, packetsPerFrame);

    /// <summary>Adds the next packets of a frame. The last packet completes the frame, and the next call starts another.</summary>
    /// <param name="bytes">The packets, which are copied.</param>
    /// <param name="packets">Number of packets.</param>
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

    /// <summary>Holds the readers back until <see cref="Release"/>, so that they get frames that arrived together in one read.</summary>
    public void Hold() => Monitor.Enter(_lock);

    /// <summary>Lets the readers read again. Called on the thread that called <see cref="Hold"/>.</summary>
    public void Release() => Monitor.Exit(_lock);

    /// <summary>Marks the end of the broadcast. Readers still get the frames in the ring.</summary>
    public void Complete()
    {
        lock (_lock)
        {
            _isComplete = true;
            Monitor.PulseAll(_lock);
        }
    }

    /// <summary>Ends all reads at once.</summary>
    public void Abort()
    {
        lock (_lock)
        {
            _isAborted = true;
            Monitor.PulseAll(_lock);
        }
    }

    /// <summary>Ends the current wait of one reader, or else its next wait.</summary>
    /// <param name="cursor">The position of the reader.</param>
    public void Wake(FrameCursor cursor)
    {
        lock (_lock)
        {
            cursor.IsWoken = true;
            Monitor.PulseAll(_lock);
        }
    }

    /// <summary>Waits for packets and copies as many as are available and fit.</summary>
    /// <param name="cursor">The position of the reader. It moves past the packets that were copied or missed.</param>
    /// <param name="destination">Room for at least one frame.</param>
    /// <param name="maxFrames">Maximum number of frames to copy.</param>
    /// <returns>The packets that were copied. Empty after <see cref="Wake"/>, after the end and after <see cref="Abort"/>.</returns>
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

    /// <summary>Whether a reader has read all frames of the finished broadcast.</summary>
    /// <param name="cursor">The position of the reader.</param>
    public bool IsAtEnd(FrameCursor cursor)
    {
        lock (_lock)
            return _isComplete && cursor.Position == _end;
    }

    /// <summary>Whether no more packets will follow for a reader.</summary>
    /// <param name="cursor">The position of the reader.</param>
    public bool HasEnded(FrameCursor cursor)
    {
        lock (_lock)
            return _isAborted || (_isComplete && cursor.Position == _end);
    }

    /// <summary>Gets the number of packets that a reader has missed so far.</summary>
    /// <remarks>A reader that is blocked in a write does not read. The packets that it misses meanwhile are included.</remarks>
    /// <param name="cursor">The position of the reader.</param>
    public long GetMissed(FrameCursor cursor)
    {
        lock (_lock)
            return cursor.Missed + CountOverwritten(cursor);
    }

    // The first frame that is still in the ring.
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

        // The length of text frames varies a little. An eighth of extra room avoids further allocations.
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
