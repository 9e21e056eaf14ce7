namespace NeuronMocap.Server.Broadcasting;

/// <summary>A ring of the newest frames of a paced broadcast. Frames are encoded once, and every client reads them at its own position.</summary>
/// <remarks>
/// The ring is the bounded queue of all clients. A client that falls behind by more than its length continues at the oldest frame left and is told
/// how many packets it missed. The writer never waits for a reader; it only waits for the lock, which a reader holds while it copies. A frame may
/// appear packet by packet. The first packet that a reader gets is always the first packet of a frame.
/// <para>
/// Each reader has its own signal, so a frame wakes only the readers that wait. Readers with an <see cref="IDirectRecipient"/> usually do not wake at all.
/// </para>
/// </remarks>
/// <param name="length">Number of frames to keep, including the frame that is appearing.</param>
/// <param name="packetsPerFrame">Number of packets in every frame.</param>
internal sealed partial class FrameLog(int length, int packetsPerFrame = 1)
{
    private readonly object _lock = new();
    private readonly Slot[] _slots = new Slot[length];
    private readonly List<FrameCursor> _cursors = [];

    // Used by the writer only.
    private readonly List<FrameCursor> _toSignal = [];
    private long _end;
    private bool _isFramePending;
    private bool _isComplete;
    private bool _isAborted;

    /// <summary>Creates the position of a reader, at the next frame to be published.</summary>
    public FrameCursor CreateCursor()
    {
        lock (_lock)
        {
            var cursor = FrameCursor.At(_end);
            _cursors.Add(cursor);
            return cursor;
        }
    }

    /// <summary>Forgets a position. Its reader does not read any more.</summary>
    /// <param name="cursor">The position of the reader.</param>
    public void Remove(FrameCursor cursor)
    {
        lock (_lock)
            _cursors.Remove(cursor);
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

            int first = slot.Packets;
            slot.Append(bytes, packets);
            _isFramePending = slot.Packets < packetsPerFrame;
            if (!_isFramePending)
                _end++;

            PassPart(bytes, packets, first);
            EndWaits();
        }

        SignalAll();
    }

    /// <summary>Marks the end of the broadcast. Readers still get the frames in the ring.</summary>
    public void Complete()
    {
        lock (_lock)
        {
            _isComplete = true;
            _cursors.ForEach(static cursor => cursor.Signal());
        }
    }

    /// <summary>Ends all reads at once.</summary>
    public void Abort()
    {
        lock (_lock)
        {
            _isAborted = true;
            _cursors.ForEach(static cursor => cursor.Signal());
        }
    }

    /// <summary>Ends the current wait of one reader, or else its next wait.</summary>
    /// <param name="cursor">The position of the reader.</param>
    public void Wake(FrameCursor cursor)
    {
        lock (_lock)
        {
            cursor.IsWoken = true;
            cursor.IsWaiting = false;
            cursor.Signal();
        }
    }

    /// <summary>Waits for packets and copies as many as are available and fit.</summary>
    /// <param name="cursor">The position of the reader. It moves past the packets that were copied or missed.</param>
    /// <param name="destination">Room for at least one frame.</param>
    /// <param name="maxFrames">Maximum number of frames to copy.</param>
    /// <returns>The packets that were copied. Empty after <see cref="Wake"/>, after the end and after <see cref="Abort"/>.</returns>
    public FrameBatch Read(FrameCursor cursor, Span<byte> destination, int maxFrames = int.MaxValue)
    {
        while (true)
        {
            lock (_lock)
            {
                cursor.IsWaiting = !HasMore(cursor) && !_isComplete && !_isAborted && !cursor.IsWoken;
                if (!cursor.IsWaiting)
                    return Copy(cursor, destination, maxFrames);
            }

            cursor.Wait();
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

    private FrameBatch Copy(FrameCursor cursor, Span<byte> destination, int maxFrames)
    {
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

    // Signals come after the lock is released. Otherwise the readers would wake only to wait for it.
    private void EndWaits()
    {
        foreach (FrameCursor cursor in _cursors)
        {
            if (!cursor.IsWaiting || !HasMore(cursor))
                continue;

            cursor.IsWaiting = false;
            _toSignal.Add(cursor);
        }
    }

    private void SignalAll()
    {
        foreach (FrameCursor cursor in _toSignal)
            cursor.Signal();

        _toSignal.Clear();
    }

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
