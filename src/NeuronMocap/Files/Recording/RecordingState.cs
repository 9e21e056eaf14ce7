namespace NeuronMocap.Recording;

// The state at a position of a recording: metadata, open connections and senders. Checkpoints and the start of a following file repeat it.
internal sealed class RecordingState(RecordingMetadata metadata)
{
    private readonly SortedDictionary<int, OpenConnection> _connections = [];
    private int _open;

    public RecordingMetadata Metadata { get; set; } = metadata;

    public void Open(RecordedConnection connection)
    {
        if (_connections.ContainsKey(connection.Number))
            throw new InvalidOperationException($"Connection {connection.Number} is already open.");

        CountOne();
        _connections.Add(connection.Number, new OpenConnection(connection with { WasOpen = true }));
    }

    public void Close(int connection)
    {
        _open -= 1 + Find(connection).Senders.Count;
        _connections.Remove(connection);
    }

    public void AddSender(int connection, int sender, string address)
    {
        SortedDictionary<int, string> senders = Find(connection).Senders;
        if (senders.ContainsKey(sender))
            throw new InvalidOperationException($"Connection {connection} already has a sender {sender}.");

        CountOne();
        senders.Add(sender, address);
    }

    public void RemoveSender(int connection, int sender)
    {
        if (!Find(connection).Senders.Remove(sender))
            throw new InvalidOperationException($"Connection {connection} has no sender {sender}.");

        _open--;
    }

    public OpenConnection Find(int connection) => _connections.TryGetValue(connection, out OpenConnection? open)
        ? open
        : throw new InvalidOperationException($"Connection {connection} is not open.");

    public RecordingState Copy()
    {
        var copy = new RecordingState(Metadata);
        foreach (OpenConnection open in _connections.Values)
        {
            copy.Open(open.Connection);
            foreach ((int sender, string address) in open.Senders)
                copy.AddSender(open.Connection.Number, sender, address);
        }

        return copy;
    }

    public void Write(EntryEncoder encoder, long time)
    {
        foreach ((string key, string value) in Metadata.Values)
            encoder.AddMetadata(time, key, value);

        foreach (OpenConnection open in _connections.Values)
        {
            encoder.AddOpened(time, open.Connection);
            foreach ((int sender, string address) in open.Senders)
                encoder.AddSender(time, open.Connection.Number, sender, address);
        }
    }

    private void CountOne()
    {
        if (_open == RecordingLayout.MaxOpen)
            throw new InvalidOperationException($"More than {RecordingLayout.MaxOpen} connections and senders are open.");

        _open++;
    }

    internal sealed class OpenConnection(RecordedConnection connection)
    {
        public RecordedConnection Connection => connection;

        public SortedDictionary<int, string> Senders { get; } = [];
    }
}
