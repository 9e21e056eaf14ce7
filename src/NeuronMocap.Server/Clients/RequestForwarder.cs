using NeuronMocap.Server.Broadcasting;

namespace NeuronMocap.Server.Clients;

/// <summary>Passes the requests of clients to the server that a reader is connected to, one after another on its own thread. Thread-safe.</summary>
/// <remarks>A server that does not read makes only this thread wait. The replies arrive in the stream of the reader.</remarks>
internal sealed class RequestForwarder
{
    // As many as a single client of a server may have waiting.
    private const int Capacity = DataCommandQueue.Capacity;

    private readonly object _lock = new();
    private readonly NeuronReader _reader;
    private readonly Queue<byte[]> _waiting = new();
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

    public void Add(ReadOnlySpan<byte> request)
    {
        lock (_lock)
        {
            if (_isStopped || _waiting.Count == Capacity)
            {
                Interlocked.Increment(ref _dropped);
                return;
            }

            _waiting.Enqueue(request.ToArray());
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

    private void Run()
    {
        while (Take() is { } request)
        {
            if (!_reader.TrySend(request))
                Interlocked.Increment(ref _dropped);
        }
    }

    private byte[]? Take()
    {
        lock (_lock)
        {
            while (_waiting.Count == 0 && !_isStopped)
                Monitor.Wait(_lock);

            return _isStopped ? null : _waiting.Dequeue();
        }
    }
}
