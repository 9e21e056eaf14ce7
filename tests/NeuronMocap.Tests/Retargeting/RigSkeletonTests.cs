using System.Numerics;
using NeuronMocap.Retargeting;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Retargeting;

// Rigs with the names and the hierarchies of other programs.
public sealed class RigSkeletonTests
{
    public static TheoryData<string> Rigs => [.. RigSkeleton.All];

    [Theory]
    [MemberData(nameof(Rigs))]
    public void Every_bone_is_found(string rig)
    {
        RigSkeleton skeleton = RigSkeleton.Load(rig);
        RigBinding binding = RigBinder.Bind(skeleton.Names, parents: skeleton.Parents);
        Assert.All(BoneHierarchy.Bones.ToArray(), bone => Assert.True(
            skeleton.Expected[(int)bone] == binding.GetNode(bone),
            $"{bone}: {NameOf(skeleton, binding.GetNode(bone))} instead of {NameOf(skeleton, skeleton.Expected[(int)bone])}"));
        Assert.Empty(binding.Ambiguities);
    }

    [Theory]
    [MemberData(nameof(Rigs))]
    public void The_figure_moves_in_one_piece(string rig)
    {
        RigSkeleton skeleton = RigSkeleton.Load(rig);
        var target = TargetRig.CreateGeneric(skeleton.Nodes, RigBinder.Bind(skeleton.Names, parents: skeleton.Parents).Nodes);
        Assert.Empty(RigValidator.Validate(target));

        SkeletonBody body = SkeletonBody.GetDefault();
        BoneTransform[] pose = TestRigs.RestPose(body);
        pose[0] = new BoneTransform(pose[0].Position + new Vector3(0, 0, 100), Quaternion.CreateFromAxisAngle(Vector3.UnitX, 0.7f));
        RetargetedPose result = RetargetAssert.Retarget(target, body, pose);
        result.UpdateWorld();
        Quaternion turn = UnityAxes.ToUnityRotation(pose[0].Rotation);
        Vector3 hips = result.WorldPositions[target.HipsNode];
        for (int node = 0; node < skeleton.Nodes.Length; node++)
        {
            if (target.GetBone(node) is null)
                continue;

            Vector3 way = target.RestPositions[node] - target.RestPositions[target.HipsNode];
            RetargetAssert.AssertNear(hips + Vector3.Transform(way, turn), result.WorldPositions[node], 1e-5f);
        }
    }

    [Theory]
    [InlineData("daz-genesis-8", "hip")]
    [InlineData("character-creator", "CC_Base_Hip")]
    public void Without_the_hierarchy_the_hips_of_known_rigs_are_found_by_name(string rig, string hips)
    {
        RigSkeleton skeleton = RigSkeleton.Load(rig);
        Assert.Equal(hips, skeleton.Names[RigBinder.Bind(skeleton.Names).GetNode(Bone.Hips)]);
    }

    [Fact]
    public void Of_several_hips_the_one_that_carries_legs_and_spine_is_taken()
    {
        string[] names = ["Root", "Hip", "Pelvis", "LeftUpLeg", "RightUpLeg", "Spine", "Head"];
        int[] parents = [-1, 0, 1, 2, 2, 1, 5];
        Assert.Equal(2, RigBinder.Bind(names).GetNode(Bone.Hips));
        Assert.Equal(1, RigBinder.Bind(names, parents: parents).GetNode(Bone.Hips));

        // A name that was given is never replaced.
        var given = new Dictionary<Bone, string> { [Bone.Hips] = "Pelvis" };
        Assert.Equal(2, RigBinder.Bind(names, overrides: given, parents: parents).GetNode(Bone.Hips));
    }

    [Fact]
    public void Hips_that_do_not_carry_the_spine_are_reported()
    {
        string[] names = ["Cog", "Pelvis", "LeftUpLeg", "RightUpLeg", "Spine", "Head"];
        int[] parents = [-1, 0, 1, 1, 0, 4];
        RigBinding binding = RigBinder.Bind(names, parents: parents);
        Assert.Equal(1, binding.GetNode(Bone.Hips));
        RigNode[] nodes = [.. names.Select((name, i) => new RigNode(name, parents[i], new Vector3(0, 0.1f, 0), Quaternion.Identity))];
        RigIssue[] issues = [.. RigValidator.Validate(TargetRig.CreateGeneric(nodes, binding.Nodes)).Where(static issue => issue.Fault == RigFault.InvalidHierarchy)];
        Assert.Equal(["Spine", "Head"], issues.Select(static issue => issue.Message.Split(',')[0]));
        Assert.All(issues, static issue => Assert.Equal((RigSeverity.Warning, false), (issue.Severity, issue.CanFix)));
    }

    [Fact]
    public void Parents_are_checked()
    {
        Assert.Throws<ArgumentException>(() => RigBinder.Bind(["Hips", "Spine"], parents: [-1]));
        Assert.Throws<ArgumentException>(() => RigBinder.Bind(["Hips", "Spine"], parents: [1, -1]));
        Assert.Throws<ArgumentException>(() => RigBinder.Bind(["Hips", "Spine"], parents: [-1, -2]));
    }

    private static string NameOf(RigSkeleton skeleton, int node) => node < 0 ? "none" : skeleton.Names[node];
}
