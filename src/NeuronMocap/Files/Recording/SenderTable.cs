using NeuronMocap.Transport;

namespace NeuronMocap.Recording;

// The senders of a UDP port that a recording contains, by number. Its limit is that of UdpSenders.
internal sealed class SenderTable
{
    private readonly Dictionary<int, long> _lastUsed = [];
    private long _clock;

    // Returns whether the sender must be recorded first, and the sender that was forgotten to make room.
    public bool IsNew(int sender, out int? forgotten)
    {
        forgotten = null;
        bool isNew = !_lastUsed.ContainsKey(sender);
        if (isNew && _lastUsed.Count >= UdpSenders.Limit)
        {
            forgotten = FindOldest();
            _lastUsed.Remove(forgotten.Value);
        }

        _lastUsed[sender] = ++_clock;
        return isNew;
    }

    private int FindOldest()
    {
        (int oldest, long used) = (0, long.MaxValue);
        foreach ((int sender, long lastUsed) in _lastUsed)
        {
            if (lastUsed < used)
                (oldest, used) = (sender, lastUsed);
        }

        return oldest;
    }
}
