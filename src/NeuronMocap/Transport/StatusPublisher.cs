namespace NeuronMocap.Transport;

// Holds the newest status and publishes changes in order, one at a time. This happens on the thread that made the change, or on a thread that is already
// publishing. It never happens inside the lock, so handlers can call any member.
internal sealed class StatusPublisher(Action<ConnectionStatus> changed)
{
    private readonly object _lock = new();
    private readonly Queue<ConnectionStatus> _pending = new();
    private bool _reporting;
    private ConnectionStatus _current = new(ConnectionState.Created, ConnectionReason.None, "Not started.");
    private ConnectionStatus? _lastFailure;
    private volatile ConnectionState _state;

    // The receive path reads it for every packet, so it needs no lock.
    public ConnectionState State => _state;

    public ConnectionStatus Current
    {
        get
        {
            lock (_lock)
                return _current;
        }
    }

    // The status that says why the last finished attempt failed; null if none failed.
    public ConnectionStatus? LastFailure
    {
        get
        {
            lock (_lock)
                return _lastFailure;
        }
    }

    public void Set(ConnectionStatus status) => TrySet(_ => true, _ => status);

    // Changes the status only if the current one allows it: watchdog, receive loop and caller can compete here. Stopped is final.
    public bool TrySet(Predicate<ConnectionStatus> allowed, Func<ConnectionStatus, ConnectionStatus> change)
    {
        lock (_lock)
        {
            if (_current.State == ConnectionState.Stopped || !allowed(_current))
                return false;

            _current = change(_current);
            _state = _current.State;
            if (_state is ConnectionState.Waiting or ConnectionState.Stopped)
                _lastFailure = _current;

            _pending.Enqueue(_current);
            if (_reporting)
                return true;

            _reporting = true;
        }

        Report();
        return true;
    }

    private void Report()
    {
        while (true)
        {
            ConnectionStatus status;
            lock (_lock)
            {
                if (!_pending.TryDequeue(out status))
                {
                    _reporting = false;
                    return;
                }
            }

            changed(status);
        }
    }
}
