namespace NeuronMocap.Recording;

// The connections and senders that are open where a recording is read: no more than a writer lets be open, so that whoever keeps them needs no more memory
// than that, whatever a file holds.
internal sealed class OpenEntries
{
    private readonly Dictionary<int, HashSet<int>?> _connections = [];
    private int _count;

    public void Clear()
    {
        _connections.Clear();
        _count = 0;
    }

    // False where one more is open than may be.
    public bool Accepts(in RecordingEntry entry) => entry.Kind switch
    {
        RecordingEntryKind.ConnectionOpened => TryOpen(entry.Connection),
        RecordingEntryKind.SenderAdded => TryAdd(entry.Connection, entry.Sender),
        RecordingEntryKind.SenderRemoved => Remove(entry.Connection, entry.Sender),
        RecordingEntryKind.ConnectionClosed => Close(entry.Connection),
        _ => true,
    };

    private bool TryOpen(int connection)
    {
        if (_connections.ContainsKey(connection))
            return true;
        if (_count == RecordingLayout.MaxOpen)
            return false;

        _connections.Add(connection, null);
        _count++;
        return true;
    }

    // The opening of the connection may have been lost.
    private bool TryAdd(int connection, int sender)
    {
        if (!TryOpen(connection))
            return false;

        HashSet<int> senders = _connections[connection] ??= [];
        if (senders.Contains(sender))
            return true;
        if (_count == RecordingLayout.MaxOpen)
            return false;

        senders.Add(sender);
        _count++;
        return true;
    }

    private bool Remove(int connection, int sender)
    {
        if (_connections.TryGetValue(connection, out HashSet<int>? senders) && senders?.Remove(sender) == true)
            _count--;

        return true;
    }

    private bool Close(int connection)
    {
        if (_connections.Remove(connection, out HashSet<int>? senders))
            _count -= 1 + (senders?.Count ?? 0);

        return true;
    }
}
