using System.Numerics;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Server;

/// <summary>The motion of one avatar: a pose for every frame number.</summary>
/// <remarks>
/// A source must be a pure function of the frame number, and thread-safe. A broadcaster can then give every client the whole motion at its own speed.
/// </remarks>
public abstract class MotionSource
{
    /// <summary>Frame rate at which the motion has its natural speed, in frames per second.</summary>
    public abstract double FrameRate { get; }

    /// <summary>Number of frames. Null if the motion never ends.</summary>
    public abstract long? FrameCount { get; }

    /// <summary>Whether the source has a position for every bone, not only for the hips.</summary>
    public abstract bool HasDisplacement { get; }

    /// <summary>Names of the bones and position of the shoulders.</summary>
    public virtual SkeletonVariant Variant => SkeletonVariant.Neck1;

    /// <summary>Writes the pose of a frame: the transforms of the 59 bones relative to their parents, in <see cref="Bone"/> order.</summary>
    /// <param name="frame">Frame number, from 0, below <see cref="FrameCount"/>.</param>
    /// <param name="pose">Room for 59 transforms, in centimetres.</param>
    public abstract void GetPose(long frame, Span<BoneTransform> pose);

    /// <summary>Gets which feet touch the ground.</summary>
    /// <param name="frame">Frame number, from 0, below <see cref="FrameCount"/>.</param>
    /// <returns>True for each foot that touches the ground.</returns>
    public abstract FootContacts GetFootContacts(long frame);

    /// <summary>Writes the body at rest.</summary>
    /// <remarks>
    /// The default implementation uses the positions of the first pose, with the hips above the origin. The ends of the bones are those of the
    /// default body (<see cref="DefaultOffsets.TryGetEndSite"/>).
    /// </remarks>
    /// <param name="offsets">Room for 59 bone positions relative to the parent bone, in <see cref="Bone"/> order; centimetres.</param>
    /// <param name="endSites">Room for 59 end points of bones, relative to the bone. Zero for bones that have children.</param>
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

    // The motion that applies at a frame, also before and after it. Used for values that are computed from a frame and its neighbours.
    internal virtual MotionSource At(long frame) => this;

    /// <summary>
    /// Writes the values of a motion packet. A source that holds values in this layout and order writes them bit for bit.
    /// </summary>
    /// <param name="frame">Frame number, from 0, below <see cref="FrameCount"/>.</param>
    /// <param name="layout">Which values the packet carries.</param>
    /// <param name="order">The rotation order of the values.</param>
    /// <param name="values">Room for <see cref="ChannelLayout.ValueCount"/> values. The values of the reference are zero.</param>
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

    // Writes the three components.
    private protected static void Write(Span<float> destination, Vector3 vector)
    {
        destination[0] = vector.X;
        destination[1] = vector.Y;
        destination[2] = vector.Z;
    }
}
