namespace NeuronMocap.Server.Broadcasting;

// Units that go to readers without a change of threads.
//
// A reader that waits has everything before the next unit. Its thread then does not use the connection, so the writer may. The log's lock orders both:
// the reader marks itself as waiting under the lock, and the writer removes the mark under the lock before the reader's thread continues.
internal sealed partial class FrameLog
{
    /// <summary>The default of <see cref="MaxDirect"/>.</summary>
    public const int DefaultMaxDirect = 16;

    /// <summary>The largest sensible value of <see cref="MaxDirect"/>. The last of so many clients gets a frame 1 to 2 ms after the first.</summary>
    public const int LargestMaxDirect = 128;

    // The part of a frame that is being published, for direct recipients. Used by the writer only.
    private readonly UnitBatch _part = new(capacity: 0);

    /// <summary>Maximum number of readers with a recipient. Further readers use their own threads, which share the processors.</summary>
    /// <remarks>Each costs the writer a system call while a client keeps up. Waking the client's thread also costs one, and a change of threads.</remarks>
    public int MaxDirect { get; init; } = DefaultMaxDirect;

    /// <summary>Lets the writer hand units to a recipient while its reader waits.</summary>
    /// <param name="cursor">The position of the reader.</param>
    /// <param name="recipient">The recipient.</param>
    public void Attach(FrameCursor cursor, IDirectRecipient recipient)
    {
        lock (_lock)
        {
            if (_cursors.Count(static other => other.Direct is not null) < MaxDirect)
                cursor.Direct = recipient;
        }
    }

    /// <summary>Adds units, each of which is a whole frame. Copies them only if a reader has not taken them directly.</summary>
    /// <param name="units">The units.</param>
    public void Publish(UnitBatch units)
    {
        if (units.Count == 0)
            return;

        lock (_lock)
        {
            long start = _end;
            long slowest = start + units.Count;
            foreach (FrameCursor cursor in _cursors)
            {
                if (cursor.IsWaiting && cursor.Direct is { } direct)
                {
                    bool isDone = TryPass(units, packetsPerFrame, first: 0, cursor, direct, out int taken);
                    cursor.MoveTo(start + taken);
                    if (!isDone)
                        EndWait(cursor);
                }

                slowest = Math.Min(slowest, cursor.Position);
            }

            // Units that nobody wants any more are not stored. No cursor ever points to them.
            for (int i = (int)Math.Max(slowest - start, 0); i < units.Count; i++)
            {
                ref Slot slot = ref _slots[(start + i) % _slots.Length];
                slot.Clear();
                slot.Append(units.BytesOf(i), packetsPerFrame);
            }

            _end = start + units.Count;
            EndWaits();
        }

        SignalAll();
    }

    // The part is already stored, and a cursor that waits has everything before it.
    private void PassPart(ReadOnlySpan<byte> bytes, int packets, int first)
    {
        foreach (FrameCursor cursor in _cursors)
        {
            if (!cursor.IsWaiting || cursor.Direct is not { } direct)
                continue;

            if (_part.Count == 0)
            {
                _part.Append(bytes);
                _part.Cut(TimeSpan.Zero, isCalculation: false);
            }

            bool isDone = TryPass(_part, packets, first, cursor, direct, out int taken);
            if (taken > 0 && _isFramePending)
                cursor.MoveWithin(cursor.Bytes + bytes.Length, first + packets);
            else if (taken > 0)
                cursor.MoveTo(_end);

            if (!isDone)
                EndWait(cursor);
        }

        _part.RemoveUnits();
    }

    // A recipient that has taken a unit in part writes the rest on its own thread. One that throws takes no more units here: its own thread goes on, meets
    // the same fault and reports it. The units of the other recipients do not depend on it. Returns whether the recipient's thread can wait on.
    private static bool TryPass(UnitBatch units, int packets, int first, FrameCursor cursor, IDirectRecipient direct, out int taken)
    {
        taken = 0;
        try
        {
            taken = direct.Take(units, packets, first);
            return direct.IsReady && taken == units.Count;
        }
        catch (Exception)
        {
            cursor.Direct = null;
            return false;
        }
    }

    private void EndWait(FrameCursor cursor)
    {
        cursor.IsWoken = true;
        cursor.IsWaiting = false;
        _toSignal.Add(cursor);
    }
}
