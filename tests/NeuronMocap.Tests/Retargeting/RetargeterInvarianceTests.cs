using System.Numerics;
using NeuronMocap.Retargeting;
using NeuronMocap.Skeleton;
using static NeuronMocap.Tests.Retargeting.RetargetAssert;

namespace NeuronMocap.Tests.Retargeting;

// Differences that must not affect the character: the export of its armature, its side, the naming of the spine.
public sealed class RetargeterInvarianceTests
{
    private static readonly Quaternion[] QuarterTurns = [.. AllQuarterTurns()];

    // The orientation of an exported armature must not affect its content.
    [Fact]
    public void A_root_rotation_does_not_change_the_motion()
    {
        var random = new Random(5);
        BoneTransform[] pose = RandomPoses.Pose(random);
        RetargetedPose straight = Retarget(TestRigs.Humanoid(), SkeletonBody.GetDefault(), pose);
        foreach (Quaternion turn in QuarterTurns)
        {
            RigNode[] nodes = TestRigs.Under(new RigNode("Armature", -1, Vector3.Zero, turn), TestRigs.HumanoidNodes());
            var found = TargetRig.CreateHumanoid(nodes, TestRigs.Under(TestRigs.NodeOf()));
            AssertTurn(turn, found.Facing, 1e-6, "facing");
            AssertAlike(straight, Retarget(found, SkeletonBody.GetDefault(), pose));

            Quaternion any = RandomPoses.Turn(random);
            nodes[0] = nodes[0] with { Rotation = any };
            AssertAlike(straight, Retarget(TargetRig.CreateHumanoid(nodes, TestRigs.Under(TestRigs.NodeOf()), any), SkeletonBody.GetDefault(), pose));
        }
    }

    [Fact]
    public void An_arm_of_a_reversed_character_goes_down()
    {
        var half = Quaternion.CreateFromAxisAngle(Vector3.UnitY, MathF.PI);
        RigNode[] nodes = TestRigs.Under(new RigNode("Armature", -1, Vector3.Zero, half), TestRigs.HumanoidNodes());
        var rig = TargetRig.CreateHumanoid(nodes, TestRigs.Under(TestRigs.NodeOf()));
        BoneTransform[] pose = TestRigs.RestPose(SkeletonBody.GetDefault());
        pose[(int)Bone.LeftArm] = pose[(int)Bone.LeftArm] with { Rotation = Quaternion.CreateFromAxisAngle(Vector3.UnitZ, -MathF.PI / 2) };
        RetargetedPose result = Retarget(rig, SkeletonBody.GetDefault(), pose);
        result.UpdateWorld();
        Vector3 arm = result.WorldPositions[rig.GetNode(HumanoidBone.LeftHand)] - result.WorldPositions[rig.GetNode(HumanoidBone.LeftUpperArm)];
        AssertNear(new Vector3(0, -0.5f, 0), arm, 1e-5f);
    }

    // The same character inside a mirror that mirrors it back, and a character in centimetres.
    [Theory]
    [InlineData(-1, 1, 1)]
    [InlineData(1, 1, -1)]
    [InlineData(-1, -1, -1)]
    [InlineData(-1, 1, -1)]
    [InlineData(0.01f, 0.01f, 0.01f)]
    [InlineData(-100, 100, 100)]
    public void A_cancelled_armature_scale_does_not_matter(float x, float y, float z)
    {
        var scale = new Vector3(x, y, z);
        var signs = new Vector3(MathF.Sign(x), MathF.Sign(y), MathF.Sign(z));
        Vector3 axis = signs * (signs.X * signs.Y * signs.Z);
        var plain = new RandomRig(6, RigScales.None);
        RigNode[] inside =
        [
            .. plain.Nodes.Select(node => node with
            {
                Position = node.Position / scale,
                Rotation = new Quaternion(new Vector3(node.Rotation.X, node.Rotation.Y, node.Rotation.Z) * axis, node.Rotation.W),
            }),
        ];
        RigNode[] nodes = TestRigs.Under(new RigNode("Armature", -1, Vector3.Zero, Quaternion.Identity, scale), inside);
        BoneTransform[] pose = RandomPoses.Pose(new Random(7));
        RetargetedPose one = Retarget(plain.Create(), SkeletonBody.GetDefault(), pose);
        RetargetedPose other = Retarget(TargetRig.CreateHumanoid(nodes, TestRigs.Under(plain.NodeOf), plain.Facing), SkeletonBody.GetDefault(), pose);
        one.UpdateWorld();
        other.UpdateWorld();
        for (int node = 0; node < plain.Nodes.Length; node++)
        {
            AssertTurn(one.WorldRotations[node], other.WorldRotations[node + 1], 3e-6, plain.Nodes[node].Name);
            AssertNear(one.WorldPositions[node], other.WorldPositions[node + 1], 2e-5f);
        }
    }

    [Fact]
    public void A_mirrored_actor_mirrors_a_symmetric_character()
    {
        var random = new Random(8);
        for (int i = 0; i < 50; i++)
        {
            TargetRig rig = SymmetricRig(random);
            BoneTransform[] pose = RandomPoses.Pose(random);
            RetargetedPose one = Retarget(rig, SkeletonBody.GetDefault(), pose);
            RetargetedPose other = Retarget(rig, SkeletonBody.GetDefault(), MirroredPose(pose));
            AssertNear(UnityAxes.Mirror(one.HipsLocalPosition), other.HipsLocalPosition, 1e-5f);
            foreach (HumanoidBone bone in TestRigs.Order)
            {
                Quaternion expected = UnityAxes.ToUnityRotation(one.LocalRotations[rig.GetNode(bone)]);
                AssertTurn(expected, other.LocalRotations[rig.GetNode(TestRigs.Partner(bone))], 3e-6, bone.ToString());
            }
        }
    }

    // One motion in both namings of the spine. Spine3 has another bone in the spine, Neck1 another in the neck.
    [Fact]
    public void Both_variants_of_a_motion_move_the_character_alike()
    {
        TargetRig rig = TestRigs.Humanoid();
        var random = new Random(9);
        for (int i = 0; i < 50; i++)
        {
            BoneTransform[] neck1 = RandomPoses.Pose(random);
            BoneTransform[] spine3 = [.. neck1];
            spine3[(int)Bone.Spine2] = neck1[(int)Bone.Spine2] with { Rotation = Quaternion.Identity };
            spine3[(int)Bone.Neck] = neck1[(int)Bone.Neck] with { Rotation = neck1[(int)Bone.Spine2].Rotation };
            spine3[(int)Bone.Neck1] = neck1[(int)Bone.Neck1] with { Rotation = neck1[(int)Bone.Neck].Rotation * neck1[(int)Bone.Neck1].Rotation };
            RetargetedPose one = Retarget(rig, SkeletonBody.GetDefault(), neck1);
            RetargetedPose other = Retarget(rig, SkeletonBody.GetDefault(SkeletonVariant.Spine3), spine3);
            foreach (HumanoidBone bone in TestRigs.Order)
                AssertTurn(one.LocalRotations[rig.GetNode(bone)], other.LocalRotations[rig.GetNode(bone)], 3e-6, bone.ToString());
        }
    }

    private static TargetRig SymmetricRig(Random random)
    {
        RigNode[] nodes = TestRigs.HumanoidNodes();
        int[] nodeByBone = TestRigs.NodeOf();
        for (int i = 0; i < nodes.Length; i++)
        {
            HumanoidBone bone = TestRigs.Order[i];
            RigNode left = nodes[nodeByBone[(int)TestRigs.Partner(bone)]];
            nodes[i] = bone == TestRigs.Partner(bone)
                ? nodes[i] with { Rotation = Quaternion.CreateFromAxisAngle(Vector3.UnitX, random.NextSingle() * 6) }
                : bone.ToString().StartsWith("Left", StringComparison.Ordinal)
                    ? nodes[i] with { Rotation = RandomPoses.Turn(random), Position = RandomPoses.Direction(random) * 0.3f }
                    : nodes[i] with { Rotation = UnityAxes.ToUnityRotation(left.Rotation), Position = UnityAxes.Mirror(left.Position) };
        }

        return TargetRig.CreateHumanoid(nodes, nodeByBone, Quaternion.Identity);
    }

    private static BoneTransform[] MirroredPose(BoneTransform[] pose)
    {
        var mirrored = new BoneTransform[pose.Length];
        foreach (Bone bone in BoneHierarchy.Bones)
        {
            string name = bone.ToString();
            string other = name.Contains("Left", StringComparison.Ordinal) ? name.Replace("Left", "Right", StringComparison.Ordinal)
                : name.Replace("Right", "Left", StringComparison.Ordinal);
            BoneTransform source = pose[(int)Enum.Parse<Bone>(other)];
            mirrored[(int)bone] = new BoneTransform(UnityAxes.Mirror(source.Position), UnityAxes.ToUnityRotation(source.Rotation));
        }

        return mirrored;
    }

    private static IEnumerable<Quaternion> AllQuarterTurns()
    {
        float quarter = MathF.PI / 2;
        for (int i = 0; i < 4; i++)
        {
            for (int j = 0; j < 4; j++)
                yield return Quaternion.CreateFromAxisAngle(Vector3.UnitY, i * quarter) * Quaternion.CreateFromAxisAngle(Vector3.UnitX, j * quarter);
            for (int j = 1; j < 4; j += 2)
                yield return Quaternion.CreateFromAxisAngle(Vector3.UnitY, i * quarter) * Quaternion.CreateFromAxisAngle(Vector3.UnitZ, j * quarter);
        }
    }
}
