namespace NeuronMocap.Server.Broadcasting;

// Units that go to readers without a change of threads.
//
// A reader that waits has everything before the next unit. Its thread then does not use the connection, so the writer may. The log's lock orders both:
// the reader marks itself as waiting under the lock, and the writer removes the mark under the lock before the reader's thread continues.
internal sealed partial class FrameLog
{
    // Each costs the writer a system call. Further readers use their own threads, which share the processors.
    private const int MaxDirect = 16;

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

    /// <summary>Adds units, each of which is a frame of one packet. Copies them only if a reader has not taken them directly.</summary>
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
                    Pass(units, cursor, direct);

                slowest = Math.Min(slowest, cursor.Position);
            }

            // Units that nobody wants any more are not stored. No cursor ever points to them.
            for (int i = (int)Math.Max(slowest - start, 0); i < units.Count; i++)
            {
                ref Slot slot = ref _slots[(start + i) % _slots.Length];
                slot.Clear();
                slot.Append(units.BytesOf(i), packets: 1);
            }

            _end = start + units.Count;
            EndWaits();
        }

        SignalAll();
    }

    // A recipient that has taken a unit in part writes the rest on its own thread. One that throws takes no more units here: its own thread goes on, meets
    // the same fault and reports it. The units of the other recipients do not depend on it.
    private void Pass(UnitBatch units, FrameCursor cursor, IDirectRecipient direct)
    {
        int taken = 0;
        try
        {
            taken = direct.Take(units);
        }
        catch (Exception)
        {
            cursor.Direct = null;
        }

        cursor.MoveTo(_end + taken);
        if (cursor.Direct is not null && direct.IsReady && taken == units.Count)
            return;

        cursor.IsWoken = true;
        cursor.IsWaiting = false;
        _toSignal.Add(cursor);
    }
}
