using System.Numerics;
using NeuronMocap.Retargeting;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Retargeting;

public sealed class BoneWeightsTests
{
    [Fact]
    public void Each_joint_bends_by_its_weight()
    {
        for (int seed = 0; seed < 300; seed++)
        {
            var random = new Random(seed);
            var character = new RandomRig(seed, (RigScales)(seed % 4));
            SkeletonBody body = RandomPoses.Body(random);
            Bone?[] sources = ExpectedMap.Sources(character, body.Variant);

            // Half a turn has two shorter ways, so joints stay clear of it.
            BoneTransform[] pose = RandomPoses.Pose(random, mostDegrees: 25);
            var options = new RetargetOptions();
            float[] weights = new float[character.Nodes.Length];
            for (int bone = 0; bone < HumanoidBones.Count; bone++)
            {
                float weight = random.Next(4) == 0 ? random.Next(2) : random.NextSingle();
                options.Weights[(HumanoidBone)bone] = weight;
                if (character.NodeOf[bone] >= 0)
                    weights[character.NodeOf[bone]] = weight;
            }

            TargetRig rig = character.Create();
            var result = new RetargetedPose(rig);
            Assert.True(new Retargeter(rig, body, options).TryRetarget(pose, result));
            result.UpdateWorld();
            var expected = new ReferenceRetargeter(character.Nodes, sources, character.Facing);
            expected.Retarget(pose, body, weights: weights);
            RetargeterReferenceTests.AssertSame(expected, result, $"seed {seed}");
            for (int node = 0; node < weights.Length; node++)
                Assert.Equal(sources[node] is not null && weights[node] > 0, result.IsDriven(node));
        }
    }

    [Fact]
    public void A_bone_without_weight_rests_and_its_children_still_bend()
    {
        TargetRig rig = new RandomRig(1, RigScales.None, HumanoidBoneSet.All).Create();
        BoneTransform[] pose = RandomPoses.Pose(new Random(2));
        RetargetedPose whole = Retarget(rig, pose, new BoneWeights());
        foreach (HumanoidBone bone in TestRigs.Order)
        {
            RetargetedPose result = Retarget(rig, pose, new BoneWeights { [bone] = 0 });
            int masked = rig.GetNode(bone);
            Assert.Equal(rig.Nodes[masked].Rotation, result.LocalRotations[masked]);
            Assert.False(result.IsDriven(masked));
            for (int node = 0; node < rig.Nodes.Length; node++)
            {
                if (node != masked)
                    Assert.Equal(whole.LocalRotations[node], result.LocalRotations[node]);
            }
        }
    }

    // Whatever the actor's body does, the arms keep the actor's pose relative to the chest.
    [Fact]
    public void A_mask_of_the_arms_is_relative_to_the_chest()
    {
        TargetRig rig = TestRigs.Humanoid();
        BoneTransform[] pose = RandomPoses.Pose(new Random(3));
        RetargetedPose one = Retarget(rig, pose, BoneWeights.Only(BodyParts.Arms | BodyParts.Fingers));
        pose[0] = new BoneTransform(new Vector3(1, 2, 3), RandomPoses.Turn(new Random(4)));
        pose[(int)Bone.Spine1] = pose[(int)Bone.Spine1] with { Rotation = RandomPoses.Turn(new Random(5)) };
        RetargetedPose other = Retarget(rig, pose, BoneWeights.Only(BodyParts.Arms | BodyParts.Fingers));
        Assert.Equal(rig.Nodes[rig.HipsNode].Position, other.HipsLocalPosition);
        foreach (HumanoidBone bone in TestRigs.Order)
        {
            int node = rig.GetNode(bone);
            bool isArm = (HumanoidBones.GetPart(bone) & (BodyParts.Arms | BodyParts.Fingers)) != BodyParts.None;
            Assert.Equal(isArm, other.IsDriven(node));
            Assert.True(Affine.Turned(one.LocalRotations[node]).AngleTo(other.LocalRotations[node]) < 3e-6, bone.ToString());
            if (!isArm)
                Assert.Equal(Quaternion.Identity, other.LocalRotations[node]);
        }
    }

    [Theory]
    [InlineData(BodyParts.Hips)]
    [InlineData(BodyParts.Spine)]
    [InlineData(BodyParts.Head)]
    [InlineData(BodyParts.LeftArm)]
    [InlineData(BodyParts.RightArm)]
    [InlineData(BodyParts.LeftFingers)]
    [InlineData(BodyParts.RightFingers)]
    [InlineData(BodyParts.LeftLeg)]
    [InlineData(BodyParts.RightLeg)]
    [InlineData(BodyParts.Legs)]
    [InlineData(BodyParts.All)]
    public void A_mask_drives_only_its_parts(BodyParts parts)
    {
        RetargetedPose humanoid = Retarget(TestRigs.Humanoid(), RandomPoses.Pose(new Random(6)), BoneWeights.Only(parts));
        foreach (HumanoidBone bone in TestRigs.Order)
        {
            bool hasSource = HumanoidMap.GetBone(bone, SkeletonVariant.Neck1, HumanoidBoneSet.All) is not null;
            Assert.Equal(hasSource && (HumanoidBones.GetPart(bone) & parts) != BodyParts.None, humanoid.IsDriven(humanoid.Rig.GetNode(bone)));
        }

        RetargetedPose generic = Retarget(TestRigs.Actor(SkeletonBody.GetDefault()), RandomPoses.Pose(new Random(6)), BoneWeights.Only(parts));
        foreach (Bone bone in BoneHierarchy.Bones)
            Assert.Equal((HumanoidBones.GetPart(bone) & parts) != BodyParts.None, generic.IsDriven(generic.Rig.GetNode(bone)));
    }

    [Fact]
    public void A_headset_has_the_head_and_nothing_else()
    {
        RetargetedPose humanoid = Retarget(TestRigs.Humanoid(), RandomPoses.Pose(new Random(7)), BoneWeights.WithoutHead());
        Assert.False(humanoid.IsDriven(humanoid.Rig.GetNode(HumanoidBone.Head)));
        Assert.Equal(49, Enumerable.Range(0, 55).Count(humanoid.IsDriven));
        Assert.True(humanoid.IsDriven(humanoid.Rig.GetNode(HumanoidBone.Neck)));

        RetargetedPose generic = Retarget(TestRigs.Actor(SkeletonBody.GetDefault()), RandomPoses.Pose(new Random(7)), BoneWeights.WithoutHead());
        Assert.Equal([(int)Bone.Head], Enumerable.Range(0, 59).Where(node => !generic.IsDriven(node)));
    }

    [Fact]
    public void The_weight_of_a_part_and_that_of_a_bone_multiply()
    {
        TargetRig rig = TestRigs.Humanoid();
        BoneTransform[] pose = TestRigs.RestPose(SkeletonBody.GetDefault());
        pose[(int)Bone.LeftForeArm] = pose[(int)Bone.LeftForeArm] with { Rotation = Quaternion.CreateFromAxisAngle(Vector3.UnitY, 1.6f) };
        var weights = new BoneWeights { [HumanoidBone.LeftLowerArm] = 0.5f };
        weights.SetPart(BodyParts.Arms, 0.25f);
        Assert.Equal(0.25f, weights.GetPart(BodyParts.LeftArm));
        Assert.Equal(1, weights.GetPart(BodyParts.LeftFingers));
        RetargetedPose result = Retarget(rig, pose, weights);
        var expected = Affine.Turned([0, 1, 0], -0.2);
        Assert.True(expected.AngleTo(result.LocalRotations[rig.GetNode(HumanoidBone.LeftLowerArm)]) < 1e-6);

        weights.Reset();
        Assert.Equal(1, weights.GetPart(BodyParts.LeftArm));
        Assert.Equal(1, weights[HumanoidBone.LeftLowerArm]);
    }

    [Fact]
    public void Bones_of_a_generic_rig_have_their_own_weights()
    {
        TargetRig rig = TestRigs.Actor(SkeletonBody.GetDefault());
        BoneTransform[] pose = RandomPoses.Pose(new Random(8));
        RetargetedPose result = Retarget(rig, pose, new BoneWeights { [Bone.LeftInHandIndex] = 0, [HumanoidBone.Head] = 0 });
        Assert.Equal([rig.GetNode(Bone.LeftInHandIndex)], Enumerable.Range(0, 59).Where(node => !result.IsDriven(node)));
    }

    // The bone at index 10 belongs to the spine in one variant and to the neck in the other.
    [Fact]
    public void The_part_of_a_bone_follows_the_variant()
    {
        SkeletonBody spine3 = SkeletonBody.GetDefault(SkeletonVariant.Spine3);
        TargetRig rig = TestRigs.Actor(spine3);
        var result = new RetargetedPose(rig);
        var options = new RetargetOptions { Weights = BoneWeights.Only(BodyParts.Spine) };
        var retargeter = new Retargeter(rig, spine3, options);
        Assert.True(retargeter.TryRetarget(RandomPoses.Pose(new Random(9)), result));
        Assert.True(result.IsDriven(rig.GetNode(Bone.Neck)));
        retargeter.SetBody(SkeletonBody.GetDefault());
        Assert.True(retargeter.TryRetarget(RandomPoses.Pose(new Random(9)), result));
        Assert.False(result.IsDriven(rig.GetNode(Bone.Neck)));
    }

    [Theory]
    [InlineData(-0.01f)]
    [InlineData(1.01f)]
    [InlineData(float.NaN)]
    public void Weights_are_from_zero_to_one(float weight)
    {
        var weights = new BoneWeights();
        Assert.Throws<ArgumentOutOfRangeException>(() => weights[HumanoidBone.Head] = weight);
        Assert.Throws<ArgumentOutOfRangeException>(() => weights[Bone.Head] = weight);
        Assert.Throws<ArgumentOutOfRangeException>(() => weights.SetPart(BodyParts.Head, weight));
        Assert.Equal(1, weights.GetPart(BodyParts.Head));
    }

    [Fact]
    public void Unknown_bones_and_parts_are_refused()
    {
        var weights = new BoneWeights();
        Assert.Throws<ArgumentOutOfRangeException>(() => weights[(HumanoidBone)55]);
        Assert.Throws<ArgumentOutOfRangeException>(() => weights[(Bone)59] = 1);
        Assert.Throws<ArgumentOutOfRangeException>(() => weights.GetPart(BodyParts.Arms));
        Assert.Throws<ArgumentOutOfRangeException>(() => weights.GetPart(BodyParts.None));
    }

    private static RetargetedPose Retarget(TargetRig rig, BoneTransform[] pose, BoneWeights weights)
    {
        var result = new RetargetedPose(rig);
        Assert.True(new Retargeter(rig, SkeletonBody.GetDefault(), new RetargetOptions { Weights = weights }).TryRetarget(pose, result));
        return result;
    }
}
