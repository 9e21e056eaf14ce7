namespace NeuronMocap.Server.Clients;

/// <summary>The values for whose changes clients have registered through a relay. The server sees one client, the relay. Not thread-safe.</summary>
internal sealed class Registrations
{
    // Servers have nine values. The limit is for clients that send garbage.
    private const int Capacity = 64;

    private readonly Dictionary<int, Entry> _entries = [];

    // The requests that register all values.
    public IEnumerable<byte[]> Requests => _entries.Values.Select(static entry => entry.Request);

    // Returns false if there is no room. The request is then valid only for the current connection.
    public bool TryAdd(int value, object client, byte[] request)
    {
        if (!_entries.TryGetValue(value, out Entry? entry))
        {
            if (_entries.Count == Capacity)
                return false;

            entry = new Entry(request);
            _entries.Add(value, entry);
        }

        entry.Clients.Add(client);
        return true;
    }

    // Returns whether no other client wants the value, so that the server may stop sending it.
    public bool Remove(int value, object client)
    {
        if (!_entries.TryGetValue(value, out Entry? entry))
            return true;

        entry.Clients.Remove(client);
        return entry.Clients.Count == 0 && _entries.Remove(value);
    }

    // Called when a client is gone. Returns the requests that registered the values which nobody wants any more.
    public IReadOnlyList<byte[]> Forget(object client)
    {
        List<byte[]> unwanted = [];
        foreach ((int value, Entry entry) in _entries.ToArray())
        {
            if (entry.Clients.Remove(client) && entry.Clients.Count == 0 && _entries.Remove(value))
                unwanted.Add(entry.Request);
        }

        return unwanted;
    }

    private sealed class Entry(byte[] request)
    {
        public byte[] Request => request;

        public HashSet<object> Clients { get; } = [];
    }
}
