using System.Numerics;
using NeuronMocap.Skeleton;
using NeuronMocap.Tool.Figures;

namespace NeuronMocap.Tool.Watch.Live;

/// <summary>A copy of the parts of a motion frame that the view shows.</summary>
internal sealed class Pose
{
    private readonly BoneTransform[] _world = new BoneTransform[BoneHierarchy.BoneCount];
    private readonly Vector3[] _angles = new Vector3[BoneHierarchy.BoneCount];
    private readonly Vector3[] _points = new Vector3[JointPositions.Count];

    public Pose(MotionFrame frame) => Take(frame);

    public MotionHeader Header { get; private set; }

    public SkeletonFormat Format { get; private set; }

    /// <summary>Whether the frame has the values of the 59 bones. If not, only the header is set.</summary>
    public bool HasSkeleton { get; private set; }

    /// <summary>The body, for data that the stream lacks: the ends of bones and, without displacement, the positions of the joints.</summary>
    public SkeletonBody Body { get; private set; } = SkeletonBody.GetDefault();

    /// <summary>The transforms of the 59 bones in the world.</summary>
    public ReadOnlySpan<BoneTransform> World => _world;

    /// <summary>
    /// Positions of the points of the <see cref="Wireframe"/> in the world, in the order of <see cref="JointPositions"/>; centimetres.
    /// </summary>
    public ReadOnlySpan<Vector3> Points => _points;

    public void Take(MotionFrame frame)
    {
        Header = frame.Header;
        Format = frame.Format;
        HasSkeleton = frame.HasSkeleton;
        if (!HasSkeleton)
            return;

        Body = SkeletonBody.GetDefault(Format.Variant);
        frame.CopyWorldTransforms(_world, Body);
        JointPositions.Copy(_world, Body, _points);
        foreach (Bone bone in BoneHierarchy.Bones)
            _angles[(int)bone] = frame.GetEulerAngles(bone);
    }

    /// <summary>Gets the position of a bone in the world, in centimetres.</summary>
    public Vector3 GetPosition(Bone bone) => _world[(int)bone].Position;

    /// <summary>Gets the three angles of a bone in degrees, in the order of the stream.</summary>
    public Vector3 GetAngles(Bone bone) => _angles[(int)bone];
}
