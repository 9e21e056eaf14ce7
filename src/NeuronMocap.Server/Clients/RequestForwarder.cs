using NeuronMocap.Protocol;
using NeuronMocap.Server.Broadcasting;

namespace NeuronMocap.Server.Clients;

/// <summary>Passes the requests of clients to the server that a reader is connected to, one after another on its own thread. Thread-safe.</summary>
/// <remarks>
/// A server that does not read makes only this thread wait. The replies arrive in the stream of the reader. A server forgets registrations with the
/// connection, so the forwarder repeats them on the next one. It cancels those that a client leaves behind.
/// </remarks>
internal sealed class RequestForwarder
{
    // As many as a single client of a server may have waiting.
    private const int Capacity = DataCommandQueue.Capacity;

    private readonly object _lock = new();
    private readonly NeuronReader _reader;
    private readonly Queue<Entry> _waiting = new();
    private readonly Queue<Entry> _renewals = new();
    private readonly Registrations _registrations = new();
    private long _dropped;
    private bool _isStopped;

    public RequestForwarder(NeuronReader reader, FaultReport report)
    {
        _reader = reader;
        Worker = new Worker("NeuronMocap requests", Run, report);
    }

    public Worker Worker { get; }

    // Requests that exceeded the capacity, or that no connection could carry.
    public long Dropped => Interlocked.Read(ref _dropped);

    public void Add(object client, in DataCommandHeader header, ReadOnlySpan<byte> request)
    {
        lock (_lock)
        {
            // Another client wants the changes, and the server would not tell the clients apart.
            if (header.CommandId == DataCommandId.UnregisterEvent && !_registrations.Remove(header.Parameter, client))
                return;

            if (_isStopped || _waiting.Count == Capacity)
            {
                Interlocked.Increment(ref _dropped);
                return;
            }

            byte[] bytes = request.ToArray();
            bool isKept = header.CommandId == DataCommandId.RegisterEvent && _registrations.TryAdd(header.Parameter, client, bytes);
            _waiting.Enqueue(new Entry(bytes, isKept));
            Monitor.Pulse(_lock);
        }
    }

    // Called when a client is gone. What it registered last is cancelled; the capacity limits the registrations, and so these requests.
    public void Forget(object client)
    {
        lock (_lock)
        {
            foreach (byte[] request in _registrations.Forget(client))
                _waiting.Enqueue(new Entry(CreateCancellation(request), IsOfRelay: true));

            Monitor.Pulse(_lock);
        }
    }

    // Called when the reader has a new connection. Registrations come before the requests that wait.
    public void Renew()
    {
        lock (_lock)
        {
            _renewals.Clear();
            foreach (byte[] request in _registrations.Requests)
                _renewals.Enqueue(new Entry(request, IsOfRelay: true));

            Monitor.Pulse(_lock);
        }
    }

    public void Stop()
    {
        lock (_lock)
        {
            _isStopped = true;
            Monitor.Pulse(_lock);
        }
    }

    // The same bytes with another command: a server of this generation expects its own version and parameters.
    private static byte[] CreateCancellation(byte[] registration)
    {
        byte[] request = [.. registration];
        DataCommandHeader.WriteCommand(request, DataCommandId.UnregisterEvent);
        return request;
    }

    private void Run()
    {
        while (Take() is { } request)
        {
            if (!_reader.TrySend(request.Bytes) && !request.IsOfRelay)
                Interlocked.Increment(ref _dropped);
        }
    }

    private Entry? Take()
    {
        lock (_lock)
        {
            while (_waiting.Count == 0 && _renewals.Count == 0 && !_isStopped)
                Monitor.Wait(_lock);

            return _isStopped ? null : (_renewals.Count > 0 ? _renewals : _waiting).Dequeue();
        }
    }

    // IsOfRelay: a registration, which the next connection gets if this one cannot carry it, or its cancellation, which then needs no connection.
    private sealed record Entry(byte[] Bytes, bool IsOfRelay);
}
