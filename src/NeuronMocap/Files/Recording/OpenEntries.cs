namespace NeuronMocap.Recording;

// Tracks the open connections and senders while a recording is read. Their number has the same limit as in a writer. A caller that stores them
// therefore needs bounded memory for any file.
internal sealed class OpenEntries
{
    private readonly Dictionary<int, HashSet<int>?> _connections = [];
    private int _count;

    public void Clear()
    {
        _connections.Clear();
        _count = 0;
    }

    // Returns false if the entry would exceed the limit.
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

    // The entry that opened the connection may have been lost.
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
