namespace NeuronMocap.Delivery;

// The queues of a reader and their dropped frames, including closed queues. Any thread.
internal sealed class QueueCounters
{
    private readonly object _lock = new();
    private readonly List<FrameQueue> _open = [];
    private readonly Dictionary<string, long> _droppedByClosed = new(StringComparer.Ordinal);
    private bool _isComplete;

    // Allocates nothing.
    public long Dropped
    {
        get
        {
            lock (_lock)
            {
                long dropped = 0;
                foreach (long closed in _droppedByClosed.Values)
                    dropped += closed;
                foreach (FrameQueue queue in _open)
                    dropped += queue.Dropped;

                return dropped;
            }
        }
    }

    public void Add(FrameQueue queue)
    {
        lock (_lock)
        {
            _open.Add(queue);
            if (_isComplete)
                queue.CompleteAdding();
        }
    }

    public void Remove(FrameQueue queue)
    {
        lock (_lock)
        {
            if (_open.Remove(queue))
                _droppedByClosed[queue.Name] = _droppedByClosed.GetValueOrDefault(queue.Name) + queue.Dropped;
        }
    }

    // Called when no more frames will arrive.
    public void CompleteAdding()
    {
        lock (_lock)
        {
            _isComplete = true;
            foreach (FrameQueue queue in _open)
                queue.CompleteAdding();
        }
    }

    public IReadOnlyList<ConsumerStatistics> Snapshot()
    {
        lock (_lock)
        {
            ILookup<string, FrameQueue> open = _open.ToLookup(static queue => queue.Name, StringComparer.Ordinal);
            return
            [
                .. _droppedByClosed.Keys.Union(open.Select(static group => group.Key), StringComparer.Ordinal)
                    .Select(name => new ConsumerStatistics(
                        name,
                        _droppedByClosed.GetValueOrDefault(name) + open[name].Sum(static queue => queue.Dropped),
                        open[name].Sum(static queue => queue.Count))),
            ];
        }
    }
}
