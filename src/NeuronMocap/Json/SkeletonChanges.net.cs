using NeuronMocap.Skeleton;

namespace NeuronMocap.Json;

/// <summary>Remembers the last written skeleton of each avatar, so that only changes are written again.</summary>
internal sealed class SkeletonChanges
{
    // The same number of avatars as a reader counts. Skeletons of further avatars are written again, which limits the memory.
    private const int MaxAvatars = 1024;

    private readonly Dictionary<(int Sender, int Avatar), (SkeletonFormat Format, int ValueCount)> _reported = [];

    /// <summary>Whether the skeleton of a frame's avatar must be written before the frame. If so, it then counts as written.</summary>
    public bool IsNew(MotionFrame frame)
    {
        (int Sender, int Avatar) key = (frame.Sender, frame.AvatarIndex);
        (SkeletonFormat Format, int ValueCount) skeleton = (frame.Format, frame.Values.Length);
        if (_reported.TryGetValue(key, out (SkeletonFormat Format, int ValueCount) last) && last == skeleton)
            return false;

        if (_reported.Count >= MaxAvatars)
            _reported.Clear();

        _reported[key] = skeleton;
        return true;
    }
}
