using System.Diagnostics;
using NeuronMocap.Motion;
using NeuronMocap.Skeleton;
using NeuronMocap.Tool.View.Performers;

namespace NeuronMocap.Tool.View.Live;

/// <summary>A performer of the stream: its body and its feet, frame by frame. Used by one thread; the description may be read on any.</summary>
internal sealed class LivePerformer
{
    private readonly BodyLearner _learner = new();
    private readonly FootContactEstimator _feet = new();
    private readonly BoneTransform[] _local = new BoneTransform[BoneHierarchy.BoneCount];
    private SkeletonBody? _learned;
    private volatile Performer _description;

    /// <summary>Creates a performer before its first frame.</summary>
    public LivePerformer(PerformerKey key, string name, int number, SkeletonBody? reported) =>
        _description = new Performer(key, name, number, reported ?? SkeletonBody.GetDefault());

    /// <summary>The performer as the page gets it.</summary>
    public Performer Description => _description;

    /// <summary>The feet on the ground.</summary>
    public FootContacts Contacts { get; private set; }

    /// <summary>The contacts in the newest calculation frame; null without calculation data.</summary>
    public FootContacts? Measured { get; set; }

    /// <summary>Takes a frame.</summary>
    /// <param name="frame">A frame of this performer.</param>
    /// <param name="reported">The body that the command channel has reported; null for none.</param>
    /// <returns>Whether the description and the contacts have changed.</returns>
    public (bool Description, bool Contacts) Take(MotionFrame frame, SkeletonBody? reported)
    {
        if (!frame.HasSkeleton)
            return default;

        SkeletonVariant variant = frame.Format.Variant;
        SkeletonBody body = reported?.Variant == variant ? reported : SkeletonBody.GetDefault(variant);
        frame.CopyLocalTransforms(_local, body);
        if (frame.Layout.HasDisplacement)
            body = (_learned = _learner.Observe(_local, variant, _learned, reported) ?? _learned) ?? body;

        return (UpdateDescription(frame.AvatarName, body), UpdateContacts(frame, body));
    }

    private bool UpdateDescription(string name, SkeletonBody body)
    {
        Performer known = _description;
        if (ReferenceEquals(known.Body, body) && name.Equals(known.Name, StringComparison.Ordinal))
            return false;

        _description = known with { Name = name, Body = body };
        return true;
    }

    private bool UpdateContacts(MotionFrame frame, SkeletonBody body)
    {
        FootContacts before = Contacts;
        ForwardKinematics.ToWorld(_local, _local, body.Variant, frame.GetReference());
        Contacts = _feet.Update(_local, body, frame.Timestamp / (double)Stopwatch.Frequency, Measured);
        return Contacts != before;
    }
}
