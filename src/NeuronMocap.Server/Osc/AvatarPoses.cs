namespace NeuronMocap.Server.Osc;

/// <summary>The newest pose of each avatar that goes to a destination. One thread uses it.</summary>
internal sealed class AvatarPoses(AvatarChoice choice)
{
    // Senders on a network can invent avatars.
    private const int Limit = 256;

    private readonly List<AvatarPose> _all = [];

    public IReadOnlyList<AvatarPose> All => _all;

    /// <summary>Number of frames that were replaced by a newer one before they were sent.</summary>
    public long Replaced { get; private set; }

    /// <summary>Number of frames of other avatars, and of frames without the 59 bones.</summary>
    public long Ignored { get; private set; }

    public void Take(MotionFrame frame)
    {
        if (!frame.HasSkeleton || !choice.Takes(frame))
        {
            Ignored++;
            return;
        }

        AvatarPose pose = Find(frame.Sender, frame.AvatarIndex);
        Replaced += pose.IsPending ? 1 : 0;
        pose.Take(frame);
    }

    private AvatarPose Find(int sender, int index)
    {
        foreach (AvatarPose pose in _all)
        {
            if (pose.Index == index && pose.Sender == sender)
                return pose;
        }

        if (_all.Count == Limit)
            RemoveOldest();

        var added = new AvatarPose(sender, index);
        _all.Add(added);
        return added;
    }

    private void RemoveOldest()
    {
        AvatarPose oldest = _all[0];
        foreach (AvatarPose pose in _all)
        {
            if (pose.Timestamp < oldest.Timestamp)
                oldest = pose;
        }

        Replaced += oldest.IsPending ? 1 : 0;
        _all.Remove(oldest);
    }
}
