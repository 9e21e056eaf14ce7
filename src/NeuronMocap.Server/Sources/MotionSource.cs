using System.Numerics;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Server;

/// <summary>
/// A performance of one avatar: a pose for every frame number. A source is a pure function of that number and safe to call from several
/// threads, so that every client of a broadcaster can be given all of it at its own speed.
/// </summary>
public abstract class MotionSource
{
    /// <summary>Frames per second at which the performance has its natural speed.</summary>
    public abstract double FrameRate { get; }

    /// <summary>Number of frames, or null when the performance never ends.</summary>
    public abstract long? FrameCount { get; }

    /// <summary>Whether the source itself has a position for every bone, not only for the hips.</summary>
    public abstract bool HasDisplacement { get; }

    /// <summary>Naming of the bones and place of the shoulders.</summary>
    public virtual SkeletonVariant Variant => SkeletonVariant.Neck1;

    /// <summary>Writes the pose of a frame: transforms of the 59 bones relative to their parents, in <see cref="Bone"/> order.</summary>
    /// <param name="frame">Frame number, from 0, below <see cref="FrameCount"/>.</param>
    /// <param name="pose">Room for 59 transforms; centimetres.</param>
    public abstract void GetPose(long frame, Span<BoneTransform> pose);

    /// <summary>Which feet are on the ground.</summary>
    /// <param name="frame">Frame number, from 0, below <see cref="FrameCount"/>.</param>
    /// <returns>True for each foot that touches.</returns>
    public abstract FootContacts GetFootContacts(long frame);

    /// <summary>
    /// Writes the body that performs, at rest. Unless a source knows better: the positions of its first pose, the hips above the origin, and the
    /// default body's ends (<see cref="DefaultOffsets.TryGetEndSite"/>).
    /// </summary>
    /// <param name="offsets">Room for the places of the 59 bones relative to their parents, in <see cref="Bone"/> order; centimetres.</param>
    /// <param name="endSites">Room for 59 places where the bones end, relative to them; zero for bones that have children.</param>
    public virtual void GetBody(Span<Vector3> offsets, Span<Vector3> endSites)
    {
        Span<BoneTransform> pose = stackalloc BoneTransform[BoneHierarchy.BoneCount];
        GetPose(0, pose);
        foreach (Bone bone in BoneHierarchy.Bones)
        {
            offsets[(int)bone] = pose[(int)bone].Position;
            DefaultOffsets.TryGetEndSite(bone, out endSites[(int)bone]);
        }

        offsets[(int)Bone.Hips] = new Vector3(0, offsets[(int)Bone.Hips].Y, 0);
    }

    // The performance as it goes on from a frame, and went before it: for what is computed from a frame and its neighbours.
    internal virtual MotionSource At(long frame) => this;

    /// <summary>
    /// Writes the values of a motion packet. A source whose own numbers are in that layout and order writes those, bit for bit.
    /// </summary>
    /// <param name="frame">Frame number, from 0, below <see cref="FrameCount"/>.</param>
    /// <param name="layout">Which values the packet carries.</param>
    /// <param name="order">Order of the rotation values.</param>
    /// <param name="values">Room for <see cref="ChannelLayout.ValueCount"/> values; the Reference node's are zero.</param>
    public virtual void WriteValues(long frame, ChannelLayout layout, RotationOrder order, Span<float> values)
    {
        Span<BoneTransform> pose = stackalloc BoneTransform[BoneHierarchy.BoneCount];
        GetPose(frame, pose);
        values[..layout.ValueCount].Clear();
        foreach (Bone bone in BoneHierarchy.Bones)
        {
            int position = layout.GetPositionIndex(bone);
            if (position >= 0)
                Write(values[position..], pose[(int)bone].Position);

            Write(values[layout.GetRotationIndex(bone)..], EulerAngles.FromQuaternion(pose[(int)bone].Rotation, order));
        }
    }

    /// <summary>Writes three components in a row.</summary>
    /// <param name="destination">Room for three values.</param>
    /// <param name="vector">What to write.</param>
    protected static void Write(Span<float> destination, Vector3 vector)
    {
        destination[0] = vector.X;
        destination[1] = vector.Y;
        destination[2] = vector.Z;
    }
}
