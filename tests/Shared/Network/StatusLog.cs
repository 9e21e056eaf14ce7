namespace NeuronMocap.Tests.Network;

// Every status that a reader reported, and a way to wait for one.
internal sealed class StatusLog
{
    private readonly object _lock = new();
    private readonly List<ConnectionStatus> _statuses = [];
    private readonly List<(Predicate<ConnectionStatus> Match, TaskCompletionSource<ConnectionStatus> Found)> _waiting = [];

    public StatusLog(NeuronReader reader) => reader.StatusChanged += OnStatus;

    public IReadOnlyList<ConnectionStatus> All
    {
        get
        {
            lock (_lock)
                return [.. _statuses];
        }
    }

    public Task<ConnectionStatus> WaitAsync(ConnectionState state) => WaitAsync(status => status.State == state);

    public Task<ConnectionStatus> WaitAsync(Predicate<ConnectionStatus> match)
    {
        var found = new TaskCompletionSource<ConnectionStatus>(TaskCreationOptions.RunContinuationsAsynchronously);
        lock (_lock)
        {
            int index = _statuses.FindIndex(match);
            if (index >= 0)
                found.SetResult(_statuses[index]);
            else
                _waiting.Add((match, found));
        }

        return found.Task.Soon();
    }

    private void OnStatus(ConnectionStatus status)
    {
        lock (_lock)
        {
            _statuses.Add(status);
            foreach ((Predicate<ConnectionStatus> match, TaskCompletionSource<ConnectionStatus> found) in _waiting)
            {
                if (match(status))
                    found.TrySetResult(status);
            }
        }
    }
}
