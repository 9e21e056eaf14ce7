namespace NeuronMocap.Compatibility.Callbacks;

// Counts the frames of each avatar of each sender from 0, for streams that carry no frame index.
internal sealed class FrameCounter
{
    // Avatar numbers come from the network. Avatars beyond this limit share one counter.
    private const int MaxAvatars = 1024;

    private readonly Dictionary<(int Sender, int Avatar), uint> _next = [];
    private uint _nextOfOthers;

    public uint Next(int sender, int avatar)
    {
        (int Sender, int Avatar) key = (sender, avatar);
        if (!_next.TryGetValue(key, out uint index) && _next.Count >= MaxAvatars)
            return _nextOfOthers++;

        _next[key] = unchecked(index + 1);
        return index;
    }
}
