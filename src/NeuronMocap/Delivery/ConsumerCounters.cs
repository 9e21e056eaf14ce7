namespace NeuronMocap.Delivery;

// The queues and views of a reader, and their dropped and skipped frames, including those of closed consumers. Any thread.
internal sealed class ConsumerCounters
{
    private readonly object _lock = new();
    private readonly List<ICountedConsumer> _open = [];
    private readonly Dictionary<string, Totals> _closed = new(StringComparer.Ordinal);
    private bool _isComplete;

    // Allocates nothing.
    public (long Dropped, long Skipped) Sum
    {
        get
        {
            lock (_lock)
            {
                Totals sum = default;
                foreach (Totals closed in _closed.Values)
                    sum = sum.Add(closed);
                foreach (ICountedConsumer consumer in _open)
                    sum = sum.Add(Totals.Of(consumer));

                return (sum.Dropped, sum.Skipped);
            }
        }
    }

    public void Add(ICountedConsumer consumer)
    {
        lock (_lock)
        {
            _open.Add(consumer);
            if (_isComplete)
                consumer.CompleteAdding();
        }
    }

    public void Remove(ICountedConsumer consumer)
    {
        lock (_lock)
        {
            if (_open.Remove(consumer))
                _closed[consumer.Name] = _closed.GetValueOrDefault(consumer.Name).Add(Totals.Of(consumer));
        }
    }

    // Called when no more frames will arrive.
    public void CompleteAdding()
    {
        lock (_lock)
        {
            _isComplete = true;
            foreach (ICountedConsumer consumer in _open)
                consumer.CompleteAdding();
        }
    }

    public IReadOnlyList<ConsumerStatistics> Snapshot()
    {
        lock (_lock)
        {
            ILookup<string, ICountedConsumer> open = _open.ToLookup(static consumer => consumer.Name, StringComparer.Ordinal);
            return
            [
                .. _closed.Keys.Union(open.Select(static group => group.Key), StringComparer.Ordinal)
                    .Select(name =>
                    {
                        Totals totals = open[name].Aggregate(_closed.GetValueOrDefault(name), static (sum, consumer) => sum.Add(Totals.Of(consumer)));
                        return new ConsumerStatistics(name, totals.Dropped, open[name].Sum(static consumer => consumer.Count), totals.Skipped);
                    }),
            ];
        }
    }

    private readonly record struct Totals(long Dropped, long Skipped)
    {
        public static Totals Of(ICountedConsumer consumer) => new(consumer.Dropped, consumer.Skipped);

        public Totals Add(Totals other) => new(Dropped + other.Dropped, Skipped + other.Skipped);
    }
}
