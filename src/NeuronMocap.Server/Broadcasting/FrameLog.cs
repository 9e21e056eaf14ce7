namespace NeuronMocap.Server.Broadcasting;

/// <summary>
/// The newest frames of a paced broadcast, encoded once and read by every client at its own position. This one ring is the bounded queue
/// of all clients: whoever falls behind by more than its length goes on at the oldest frame that is left and is told how many it missed.
/// The writer never waits for a reader, only for the lock, which a reader holds while it copies.
/// </summary>
internal sealed class FrameLog(int length, int frameSize)
{
    private readonly object _gate = new();
    private readonly byte[]?[] _slots = new byte[]?[length];
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
            frame.CopyTo(_slots[_end % _slots.Length] ??= new byte[frameSize]);
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

    /// <summary>Waits for frames and copies as many as are there and fit.</summary>
    /// <param name="cursor">The reader's place; moved past the frames copied and missed.</param>
    /// <param name="destination">Room for at least one frame.</param>
    /// <returns>Number of bytes, a multiple of the frame size; 0 after the end and after <see cref="Abort"/>.</returns>
    public int Read(FrameCursor cursor, Span<byte> destination)
    {
        lock (_gate)
        {
            while (cursor.Position == _end && !_isComplete && !_isAborted)
                Monitor.Wait(_gate);

            long missed = CountOverwritten(cursor);
            cursor.Missed += missed;
            cursor.Position += missed;
            int written = 0;
            while (!_isAborted && cursor.Position < _end && destination.Length - written >= frameSize)
            {
                _slots[cursor.Position % _slots.Length].CopyTo(destination[written..]);
                written += frameSize;
                cursor.Position++;
            }

            return written;
        }
    }

    /// <summary>Whether a reader has had everything that there will ever be.</summary>
    /// <param name="cursor">The reader's place.</param>
    public bool IsAtEnd(FrameCursor cursor)
    {
        lock (_gate)
            return _isComplete && cursor.Position == _end;
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
}
