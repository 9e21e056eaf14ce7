using System.Diagnostics;
using NeuronMocap.Motion;

namespace NeuronMocap.Tool.Watch.Live;

/// <summary>The newest pose of one avatar, and its feet on the ground.</summary>
/// <param name="avatar">Number of the avatar.</param>
/// <param name="frame">Its first frame.</param>
internal sealed class AvatarView(int avatar, MotionFrame frame)
{
    private readonly FootContactEstimator _feet = new();

    public int Avatar => avatar;

    public string Name { get; private set; } = string.Empty;

    public Pose Pose { get; } = new(frame);

    /// <summary>When the newest frame arrived, in ticks of <see cref="Stopwatch"/>.</summary>
    public long Timestamp { get; private set; }

    /// <summary>The feet on the ground, estimated from the motion. Null without a skeleton.</summary>
    public FootContacts? Contacts { get; private set; }

    /// <summary>Takes a frame of this avatar.</summary>
    public void Take(MotionFrame newest)
    {
        Name = newest.AvatarName;
        Timestamp = newest.Timestamp;
        Pose.Take(newest);
        Contacts = Pose.HasSkeleton ? _feet.Update(Pose.World, Pose.Body, newest.Timestamp / (double)Stopwatch.Frequency) : null;
    }
}
