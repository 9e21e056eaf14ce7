namespace NeuronMocap.Server.Broadcasting;

/// <summary>
/// The newest frames of a paced broadcast, encoded once and read by every client at its own position. This one ring is the bounded queue
/// of all clients: whoever falls behind by more than its length goes on at the oldest frame that is left and is told how many it missed.
/// The writer never waits for a reader, only for the lock, which a reader holds while it copies.
/// </summary>
internal sealed class FrameLog(int length)
{
    private readonly object _gate = new();
    private readonly Slot[] _slots = new Slot[length];
    private long _end;
    private bool _isComplete;
    private bool _isAborted;

    /// <summary>Makes a reader's place: at the next frame to be published.</summary>
    public FrameCursor CreateCursor()
    {
        lock (_gate)
            return new FrameCursor { Position = _end };
    }

    /// <summary>Adds a frame; the oldest gives way when the ring is full.</summary>
    /// <param name="frame">Exactly one frame; copied.</param>
    public void Publish(ReadOnlySpan<byte> frame)
    {
        lock (_gate)
        {
            _slots[_end % _slots.Length].Write(frame);
            _end++;
            Monitor.PulseAll(_gate);
        }
    }

    /// <summary>Says that no frame will follow; readers still get those that are there.</summary>
    public void Complete()
    {
        lock (_gate)
        {
            _isComplete = true;
            Monitor.PulseAll(_gate);
        }
    }

    /// <summary>Sends all readers away at once.</summary>
    public void Abort()
    {
        lock (_gate)
        {
            _isAborted = true;
            Monitor.PulseAll(_gate);
        }
    }

    /// <summary>Ends the wait of one reader, this one or else its next.</summary>
    /// <param name="cursor">The reader's place.</param>
    public void Wake(FrameCursor cursor)
    {
        lock (_gate)
        {
            cursor.IsWoken = true;
            Monitor.PulseAll(_gate);
        }
    }

    /// <summary>Waits for frames and copies as many as are there and fit.</summary>
    /// <param name="cursor">The reader's place; moved past the frames copied and missed.</param>
    /// <param name="destination">Room for at least one frame.</param>
    /// <param name="maxFrames">Not more than these.</param>
    /// <returns>What was copied; nothing after <see cref="Wake"/>, after the end and after <see cref="Abort"/>.</returns>
    public FrameBatch Read(FrameCursor cursor, Span<byte> destination, int maxFrames = int.MaxValue)
    {
        lock (_gate)
        {
            while (cursor.Position == _end && !_isComplete && !_isAborted && !cursor.IsWoken)
                Monitor.Wait(_gate);

            cursor.IsWoken = false;
            long missed = CountOverwritten(cursor);
            cursor.Missed += missed;
            cursor.Position += missed;
            int written = 0;
            long first = cursor.Position;
            while (!_isAborted && cursor.Position < _end && cursor.Position - first < maxFrames)
            {
                ReadOnlySpan<byte> frame = _slots[cursor.Position % _slots.Length].Frame;
                if (!frame.TryCopyTo(destination[written..]))
                    break;

                written += frame.Length;
                cursor.Position++;
            }

            return new FrameBatch(written, (int)(cursor.Position - first));
        }
    }

    /// <summary>Whether a reader has had everything that there will ever be.</summary>
    /// <param name="cursor">The reader's place.</param>
    public bool IsAtEnd(FrameCursor cursor)
    {
        lock (_gate)
            return _isComplete && cursor.Position == _end;
    }

    /// <summary>Whether there will be nothing more for a reader.</summary>
    /// <param name="cursor">The reader's place.</param>
    public bool IsOver(FrameCursor cursor)
    {
        lock (_gate)
            return _isAborted || (_isComplete && cursor.Position == _end);
    }

    /// <summary>
    /// How many frames a reader has lost so far. One that is stuck in a write does not read: what it has lost meanwhile is counted here.
    /// </summary>
    /// <param name="cursor">The reader's place.</param>
    public long GetMissed(FrameCursor cursor)
    {
        lock (_gate)
            return cursor.Missed + CountOverwritten(cursor);
    }

    private long CountOverwritten(FrameCursor cursor) => Math.Max(0, _end - _slots.Length - cursor.Position);

    private struct Slot
    {
        private byte[]? _bytes;
        private int _length;

        public readonly ReadOnlySpan<byte> Frame => _bytes.AsSpan(0, _length);

        // Text frames change their length a little: an eighth more, and the memory is taken once.
        public void Write(ReadOnlySpan<byte> frame)
        {
            if (_bytes is null)
                _bytes = new byte[frame.Length];
            else if (_bytes.Length < frame.Length)
                _bytes = new byte[frame.Length + (frame.Length / 8)];

            frame.CopyTo(_bytes);
            _length = frame.Length;
        }
    }
}
