using System.Numerics;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tool.Figures;

/// <summary>The 59 bones of a take, and the ends of the outermost bones. Not thread-safe.</summary>
internal sealed class BodyMotion : PointMotion
{
    private readonly MotionSource _source;
    private readonly BoneTransform[] _world = new BoneTransform[BoneHierarchy.BoneCount];
    private readonly SkeletonBody _body;

    /// <summary>Creates the points of a take.</summary>
    /// <param name="source">A source that has an end.</param>
    public BodyMotion(MotionSource source)
    {
        _source = source;
        FrameCount = source.FrameCount ?? throw new ArgumentException("The source must have an end.", nameof(source));
        Vector3[] offsets = new Vector3[BoneHierarchy.BoneCount];
        Vector3[] endSites = new Vector3[BoneHierarchy.BoneCount];
        source.GetBody(offsets, endSites);
        _body = new SkeletonBody(offsets, endSites, source.Variant);
        Roles = new PointRoles
        {
            Root = (int)Bone.Hips,
            HeadTop = JointPositions.GetEndSiteIndex(Bone.Head),
            LeftFoot = [(int)Bone.LeftFoot, JointPositions.GetEndSiteIndex(Bone.LeftFoot)],
            RightFoot = [(int)Bone.RightFoot, JointPositions.GetEndSiteIndex(Bone.RightFoot)],
            LeftHand = (int)Bone.LeftHand,
            RightHand = (int)Bone.RightHand,
            LeftThigh = (int)Bone.LeftUpLeg,
            RightThigh = (int)Bone.RightUpLeg,
        };
    }

    public override double FrameRate => _source.FrameRate;

    public override long FrameCount { get; }

    public override int PointCount => JointPositions.Count;

    public override ReadOnlySpan<WireframeLine> Lines => Wireframe.Lines(_source.Variant);

    public override PointRoles Roles { get; }

    public override bool IsInCentimetres => true;

    public override void GetPoints(long frame, Span<Vector3> points)
    {
        _source.GetPose(frame, _world);
        ForwardKinematics.ToWorld(_world, _world, _source.Variant);
        JointPositions.Copy(_world, _body, points);
    }

    public override FootContacts? GetContacts(long frame) => _source.GetFootContacts(frame);
}
