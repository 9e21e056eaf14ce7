using NeuronMocap.Skeleton;

namespace NeuronMocap.Tool.Output;

/// <summary>Which skeleton was told of each avatar, so that it is told again only where it is another one.</summary>
internal sealed class ToldSkeletons
{
    // As many avatars as a reader keeps figures of. Who sends more is told anew, and costs no memory.
    private const int MostAvatars = 1024;

    private readonly Dictionary<(int Source, int Avatar), (SkeletonFormat Format, int ValueCount)> _told = [];

    /// <summary>Whether the skeleton of a frame's avatar is to be told before the frame; from then on it counts as told.</summary>
    public bool IsNew(MotionFrame frame)
    {
        (int Source, int Avatar) key = (frame.Source, frame.AvatarIndex);
        (SkeletonFormat Format, int ValueCount) skeleton = (frame.Format, frame.Values.Length);
        if (_told.TryGetValue(key, out (SkeletonFormat Format, int ValueCount) told) && told == skeleton)
            return false;

        if (_told.Count >= MostAvatars)
            _told.Clear();

        _told[key] = skeleton;
        return true;
    }
}
