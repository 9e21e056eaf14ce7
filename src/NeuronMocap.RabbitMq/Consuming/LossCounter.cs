namespace NeuronMocap.RabbitMq.Consuming;

// Follows the numbers of frames, for each run of a publisher and each routing key. Not thread-safe.
internal sealed class LossCounter
{
    // A stranger can invent any number of publishers.
    private const int MaxEntries = 8192;

    private readonly Dictionary<(long Run, string Key), long> _last = [];

    public long Lost { get; private set; }

    public long Duplicates { get; private set; }

    // Returns false for a frame that was there before: a publisher sends frames again if a broker ended before it confirmed them.
    public bool Take(long run, string key, long number)
    {
        if (!_last.TryGetValue((run, key), out long last))
        {
            if (_last.Count >= MaxEntries)
                _last.Clear();
        }
        else if (number <= last)
        {
            Duplicates++;
            return false;
        }
        else
        {
            Lost += number - last - 1;
        }

        _last[(run, key)] = number;
        return true;
    }
}
