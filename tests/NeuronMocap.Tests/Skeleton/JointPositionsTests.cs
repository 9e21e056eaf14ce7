using System.Numerics;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Skeleton;

public sealed class JointPositionsTests
{
    [Fact]
    public void The_points_are_those_of_all_joints_and_then_of_the_13_ends()
    {
        BoneTransform[] world = Pose();
        Vector3[] points = new Vector3[JointPositions.Count];
        JointPositions.Copy(world, SkeletonBody.GetDefault(), points);

        Assert.Equal(72, JointPositions.Count);
        foreach (Bone bone in BoneHierarchy.Bones)
        {
            Assert.Equal(world[(int)bone].Position, points[(int)bone]);
            int end = JointPositions.GetEndSiteIndex(bone);
            bool isLeaf = DefaultOffsets.TryGetEndSite(bone, out Vector3 offset);
            Assert.Equal(isLeaf, end >= 0);
            if (isLeaf)
                Assert.Equal(world[(int)bone].TransformPoint(offset), points[end]);
        }

        Assert.Equal(Enumerable.Range(59, 13), JointPositions.EndSiteBones.ToArray().Select(JointPositions.GetEndSiteIndex));
    }

    [Fact]
    public void The_lowest_point_may_be_an_end()
    {
        BoneTransform[] world = Pose();
        var body = SkeletonBody.GetDefault();
        Vector3[] points = new Vector3[JointPositions.Count];
        JointPositions.Copy(world, body, points);

        Vector3 lowest = JointPositions.GetLowest(world, body);

        Assert.Equal(points.Min(point => point.Y), lowest.Y);
        Assert.Contains(lowest, points);
        Assert.Contains(lowest, points[59..]);
    }

    [Fact]
    public void Too_few_transforms_and_too_little_room_are_refused()
    {
        var body = SkeletonBody.GetDefault();
        Assert.Equal("world", Assert.Throws<ArgumentException>(() => JointPositions.Copy(new BoneTransform[58], body, new Vector3[72])).ParamName);
        Assert.Equal("positions", Assert.Throws<ArgumentException>(() => JointPositions.Copy(new BoneTransform[59], body, new Vector3[71])).ParamName);
        Assert.Equal("world", Assert.Throws<ArgumentException>(() => JointPositions.GetLowest(new BoneTransform[58], body)).ParamName);
        Assert.Throws<ArgumentOutOfRangeException>(() => JointPositions.GetEndSiteIndex((Bone)59));
    }

    // The right leg points slightly down, so its toes are the lowest point.
    private static BoneTransform[] Pose()
    {
        BoneTransform[] pose = new BoneTransform[59];
        SkeletonBody.GetDefault().CopyRestPose(pose);
        pose[(int)Bone.RightFoot] = pose[(int)Bone.RightFoot] with { Rotation = EulerAngles.ToQuaternion(new Vector3(0, 30, 0), RotationOrder.YXZ) };
        ForwardKinematics.ToWorld(pose, pose);
        return pose;
    }
}
