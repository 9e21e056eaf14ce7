using System.Numerics;
using NeuronMocap.Retargeting;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Retargeting;

public sealed class RetargeterTests
{
    private static readonly Quaternion[] QuarterTurns = [.. AllQuarterTurns()];

    [Theory]
    [InlineData(SkeletonVariant.Neck1)]
    [InlineData(SkeletonVariant.Spine3)]
    public void The_actors_own_skeleton_moves_as_the_actor(SkeletonVariant variant)
    {
        var body = SkeletonBody.GetDefault(variant);
        TargetRig rig = TestRigs.Actor(body);
        var random = new Random(1);
        for (int i = 0; i < 100; i++)
        {
            BoneTransform[] pose = RandomPoses.Pose(random);
            RetargetedPose result = Retarget(rig, body, pose);
            AssertNear(UnityAxes.ToUnityPosition(pose[0].Position), result.HipsLocalPosition, 1e-5f);
            foreach (Bone bone in BoneHierarchy.Bones)
                AssertTurn(UnityAxes.ToUnityRotation(pose[(int)bone].Rotation), result.LocalRotations[rig.GetNode(bone)], 2e-6, bone.ToString());
        }
    }

    [Fact]
    public void An_actor_at_rest_leaves_every_character_at_rest()
    {
        for (int seed = 0; seed < 500; seed++)
        {
            var character = new RandomRig(seed, (RigScales)(seed % 4));
            TargetRig rig = character.Create();
            SkeletonBody body = SkeletonBody.GetDefault((SkeletonVariant)(seed % 2));
            RetargetedPose result = Retarget(rig, body, TestRigs.RestPose(body));
            result.UpdateWorld();
            AssertNear(rig.RestPositions[rig.HipsNode], result.WorldPositions[rig.HipsNode], 1e-5f);
            for (int node = 0; node < character.Nodes.Length; node++)
                AssertTurn(character.Nodes[node].Rotation, result.LocalRotations[node], 1e-6, $"seed {seed}, {character.Nodes[node].Name}");
        }
    }

    // The bone is gone from the map, not from the character: its rotation has to arrive at those that hang from it.
    [Theory]
    [InlineData(HumanoidBone.UpperChest)]
    [InlineData(HumanoidBone.UpperChest, HumanoidBone.Chest)]
    [InlineData(HumanoidBone.LeftShoulder, HumanoidBone.RightShoulder)]
    [InlineData(HumanoidBone.Neck)]
    [InlineData(HumanoidBone.LeftIndexProximal)]
    [InlineData(HumanoidBone.LeftLowerArm)]
    public void A_missing_bones_rotation_reaches_its_children(params HumanoidBone[] missing)
    {
        TargetRig whole = TestRigs.Humanoid();
        TargetRig lacking = TestRigs.Humanoid(1, missing);
        BoneTransform[] pose = RandomPoses.Pose(new Random(2));
        foreach (SkeletonVariant variant in Enum.GetValues<SkeletonVariant>())
        {
            RetargetedPose one = Retarget(whole, SkeletonBody.GetDefault(variant), pose);
            RetargetedPose other = Retarget(lacking, SkeletonBody.GetDefault(variant), pose);
            one.UpdateWorld();
            other.UpdateWorld();
            foreach (HumanoidBone bone in TestRigs.Order)
            {
                // The topmost bone of the trunk stands for those above it too.
                int node = lacking.GetNode(bone);
                if (node >= 0 && bone is not (HumanoidBone.Spine or HumanoidBone.Chest) && !IsRest(bone))
                    AssertTurn(one.WorldRotations[node], other.WorldRotations[node], 3e-6, $"{bone}, {variant}");
            }

            foreach (HumanoidBone bone in missing)
            {
                int node = whole.GetNode(bone);
                Assert.False(other.IsDriven(node));
                Assert.Equal(Quaternion.Identity, other.LocalRotations[node]);
            }
        }
    }

    [Fact]
    public void A_twist_bone_between_stays_at_rest_and_what_hangs_from_it_is_right()
    {
        RigNode[] nodes = TestRigs.HumanoidNodes();
        int[] nodeByBone = TestRigs.NodeOf();
        int forearm = nodeByBone[(int)HumanoidBone.LeftLowerArm];
        int hand = nodeByBone[(int)HumanoidBone.LeftHand];
        Quaternion twist = RandomPoses.Turn(new Random(3));
        var back = Quaternion.Conjugate(twist);

        // At the end of the list, so the hand has to move behind it.
        nodes = [.. nodes, new RigNode("Twist", forearm, nodes[hand].Position / 2, twist), nodes[hand] with { Parent = nodes.Length, Rotation = back }];
        nodeByBone[(int)HumanoidBone.LeftHand] = nodes.Length - 1;

        // One that is a bone without a source is no different.
        nodeByBone[(int)HumanoidBone.Jaw] = nodes.Length - 2;
        foreach (HumanoidBone bone in TestRigs.Order.Where(bone => HumanoidBones.GetPart(bone) == BodyParts.LeftFingers))
            nodeByBone[(int)bone] = -1;

        BoneTransform[] pose = RandomPoses.Pose(new Random(4));
        RetargetedPose plain = Retarget(TestRigs.Humanoid(), SkeletonBody.GetDefault(), pose);
        RetargetedPose twisted = Retarget(TargetRig.CreateHumanoid(nodes, nodeByBone), SkeletonBody.GetDefault(), pose);
        plain.UpdateWorld();
        twisted.UpdateWorld();
        AssertTurn(plain.WorldRotations[hand], twisted.WorldRotations[^1], 3e-6, "hand");
        Assert.Equal(twisted.Rig.Nodes[^2].Rotation, twisted.LocalRotations[^2]);
        Assert.False(twisted.IsDriven(nodes.Length - 2));
    }

    // Which way an armature was exported makes no difference to what is inside.
    [Fact]
    public void A_character_that_is_turned_in_its_root_moves_alike()
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
    public void Turned_by_half_an_arm_that_goes_down_goes_down()
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

    // The same character, drawn inside a mirror that mirrors it back; and one in centimetres.
    [Theory]
    [InlineData(-1, 1, 1)]
    [InlineData(1, 1, -1)]
    [InlineData(-1, -1, -1)]
    [InlineData(-1, 1, -1)]
    [InlineData(0.01f, 0.01f, 0.01f)]
    [InlineData(-100, 100, 100)]
    public void A_scaled_armature_that_is_undone_below_makes_no_difference(float x, float y, float z)
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

    // One motion in both namings of the spine: Spine3 has a bone more in the spine, Neck1 one more in the neck.
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

    [Fact]
    public void Another_body_may_have_another_variant()
    {
        TargetRig rig = TestRigs.Humanoid();
        BoneTransform[] pose = RandomPoses.Pose(new Random(10));
        RetargetedPose expected = Retarget(rig, SkeletonBody.GetDefault(SkeletonVariant.Spine3), pose);
        var retargeter = new Retargeter(rig, SkeletonBody.GetDefault());
        var result = new RetargetedPose(rig);
        Assert.True(retargeter.TryRetarget(pose, result));
        int chest = rig.GetNode(HumanoidBone.UpperChest);
        Assert.True(Affine.Turned(expected.LocalRotations[chest]).AngleTo(result.LocalRotations[chest]) > 0.1);

        retargeter.SetBody(SkeletonBody.GetDefault(SkeletonVariant.Spine3));
        Assert.True(retargeter.TryRetarget(pose, result));
        Assert.Equal(SkeletonVariant.Spine3, retargeter.Body.Variant);
        AssertAlike(expected, result, 0);
    }

    // Quaternions that are recorded or blended number by number must not change their sign from frame to frame.
    [Fact]
    public void Rotations_go_on_in_the_same_hemisphere()
    {
        for (int seed = 0; seed < 20; seed++)
        {
            var random = new Random(seed);
            Vector3[] axes = [.. Enumerable.Range(0, BoneHierarchy.BoneCount).Select(_ => RandomPoses.Direction(random))];
            TargetRig rig = new RandomRig(seed, (RigScales)(seed % 4)).Create();
            var retargeter = new Retargeter(rig, SkeletonBody.GetDefault());
            var result = new RetargetedPose(rig);
            Quaternion[] before = result.LocalRotations.ToArray();
            for (int degrees = 0; degrees < 750; degrees += 5)
            {
                // Whatever sign they arrive with.
                BoneTransform[] pose =
                [
                    .. axes.Select(axis => new BoneTransform(
                        Vector3.Zero, Quaternion.CreateFromAxisAngle(axis, degrees * MathF.PI / 180) * (random.Next(2) == 0 ? 1 : -1))),
                ];
                Assert.True(retargeter.TryRetarget(pose, result));
                for (int node = 0; node < before.Length; node++)
                    Assert.True(Quaternion.Dot(before[node], result.LocalRotations[node]) > (degrees == 0 ? 0 : 0.9f), $"seed {seed}, {degrees}, {node}");

                before = result.LocalRotations.ToArray();
            }
        }
    }

    [Theory]
    [InlineData(RigScales.None)]
    [InlineData(RigScales.Signs)]
    [InlineData(RigScales.Sheared)]
    internal void Nothing_is_allocated(RigScales scales)
    {
        TargetRig rig = new RandomRig(11, scales).Create();
        var options = new RetargetOptions();
        options.Weights.SetPart(BodyParts.Arms, 0.5f);
        options.Weights.SetPart(BodyParts.Head, 0);
        var retargeter = new Retargeter(rig, SkeletonBody.GetDefault(), options);
        var result = new RetargetedPose(rig);
        BoneTransform[] pose = RandomPoses.Pose(new Random(12));
        BoneTransform[] broken = [.. pose];
        broken[5] = default;
        Allocations.AssertNone(() =>
        {
            retargeter.TryRetarget(pose, result, BoneTransform.Identity);
            retargeter.TryRetarget(broken, result);
            result.UpdateWorld();
            result.SetWorldRotation(rig.HipsNode, Quaternion.Identity);
            result.SetHipsWorldPosition(Vector3.One);
            result.Reset();
        });
    }

    private static bool IsRest(HumanoidBone bone) =>
        HumanoidMap.GetSource(bone, SkeletonVariant.Neck1, HumanoidBoneSet.All) is null;

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

    private static RetargetedPose Retarget(TargetRig rig, SkeletonBody body, BoneTransform[] pose)
    {
        var result = new RetargetedPose(rig);
        Assert.True(new Retargeter(rig, body).TryRetarget(pose, result));
        return result;
    }

    // The second may have nodes above the first's.
    private static void AssertAlike(RetargetedPose expected, RetargetedPose actual, int above = 1)
    {
        AssertNear(expected.HipsLocalPosition, actual.HipsLocalPosition, 1e-5f);
        for (int node = 0; node < expected.LocalRotations.Length; node++)
            AssertTurn(expected.LocalRotations[node], actual.LocalRotations[node + above], 3e-6, expected.Rig.Nodes[node].Name);
    }

    private static void AssertTurn(Quaternion expected, Quaternion actual, double tolerance, string where)
    {
        double angle = Affine.Turned(expected).AngleTo(actual);
        Assert.True(angle <= tolerance, $"{where}: off by {angle:e2} rad");
    }

    private static void AssertNear(Vector3 expected, Vector3 actual, float tolerance) =>
        Assert.True(Vector3.Distance(expected, actual) <= tolerance, $"{expected} and {actual}");
}
