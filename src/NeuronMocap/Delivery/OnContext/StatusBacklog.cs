namespace NeuronMocap.Delivery;

// The changes of status that wait for the context. Any thread adds; the context takes. If the context is busy for long, only the newest changes are kept.
internal sealed class StatusBacklog
{
    private const int Capacity = 64;

    private readonly object _lock = new();
    private readonly Queue<ConnectionStatus> _waiting = new();
    private volatile int _count;

    public bool IsEmpty => _count == 0;

    public void Add(ConnectionStatus status)
    {
        lock (_lock)
        {
            if (_waiting.Count == Capacity)
                _waiting.Dequeue();

            _waiting.Enqueue(status);
            _count = _waiting.Count;
        }
    }

    public bool TryTake(out ConnectionStatus status)
    {
        status = default;
        if (IsEmpty)
            return false;

        lock (_lock)
        {
            if (_waiting.Count == 0)
                return false;

            status = _waiting.Dequeue();
            _count = _waiting.Count;
            return true;
        }
    }
}
