namespace NeuronMocap.Commands;

// Matches replies to the calls that wait for them. The receive thread completes calls; other threads wait. A reply completes the oldest waiting call that
// it fits, because a server answers in the order of the requests.
internal sealed class ReplyWaiters
{
    private readonly object _lock = new();
    private readonly List<Waiter> _waiters = [];
    private volatile bool _isEmpty = true;

    public bool IsEmpty => _isEmpty;

    public Waiter Add(Func<DataCommandReply, bool> fits)
    {
        var waiter = new Waiter(fits);
        lock (_lock)
        {
            _waiters.Add(waiter);
            _isEmpty = false;
        }

        return waiter;
    }

    public void Remove(Waiter waiter)
    {
        lock (_lock)
        {
            _waiters.Remove(waiter);
            _isEmpty = _waiters.Count == 0;
        }
    }

    public void Complete(DataCommandReply reply)
    {
        Waiter? found;
        lock (_lock)
        {
            found = _waiters.Find(waiter => waiter.Fits(reply));
            if (found is null)
                return;

            _waiters.Remove(found);
            _isEmpty = _waiters.Count == 0;
        }

        found.Reply.TrySetResult(reply);
    }

    public void FailAll()
    {
        Waiter[] waiting;
        lock (_lock)
        {
            waiting = [.. _waiters];
            _waiters.Clear();
            _isEmpty = true;
        }

        foreach (Waiter waiter in waiting)
            waiter.Reply.TrySetException(new NeuronCommandException(CommandFailure.Closed, "The connection ended before the reply arrived."));
    }

    internal sealed class Waiter(Func<DataCommandReply, bool> fits)
    {
        public TaskCompletionSource<DataCommandReply> Reply { get; } = new(TaskCreationOptions.RunContinuationsAsynchronously);

        public bool Fits(DataCommandReply reply) => fits(reply);
    }
}
