using NeuronMocap.Transport;

namespace NeuronMocap.Recording;

// Which senders of a UDP port a recording has told, by their numbers. Remembers as many as UdpSenders does.
internal sealed class SenderTable
{
    private readonly Dictionary<int, long> _lastUsed = [];
    private long _clock;

    // Whether the sender has to be told first; and which one was forgotten for it.
    public bool IsNew(int source, out int? forgotten)
    {
        forgotten = null;
        bool isNew = !_lastUsed.ContainsKey(source);
        if (isNew && _lastUsed.Count >= UdpSenders.Limit)
        {
            forgotten = FindOldest();
            _lastUsed.Remove(forgotten.Value);
        }

        _lastUsed[source] = ++_clock;
        return isNew;
    }

    private int FindOldest()
    {
        (int oldest, long used) = (0, long.MaxValue);
        foreach ((int source, long lastUsed) in _lastUsed)
        {
            if (lastUsed < used)
                (oldest, used) = (source, lastUsed);
        }

        return oldest;
    }
}
