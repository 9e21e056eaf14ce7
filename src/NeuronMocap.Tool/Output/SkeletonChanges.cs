using NeuronMocap.Skeleton;

namespace NeuronMocap.Tool.Output;

/// <summary>The skeleton that was written last for each avatar, so that only a change is written again.</summary>
internal sealed class SkeletonChanges
{
    // As many avatars as a reader counts. Beyond that, skeletons are written again instead of taking memory.
    private const int MaxAvatars = 1024;

    private readonly Dictionary<(int Sender, int Avatar), (SkeletonFormat Format, int ValueCount)> _reported = [];

    /// <summary>Whether the skeleton of a frame's avatar must be written before the frame; from then on it counts as written.</summary>
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
