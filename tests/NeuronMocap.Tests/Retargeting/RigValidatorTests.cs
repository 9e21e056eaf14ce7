using System.Numerics;
using NeuronMocap.Retargeting;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Retargeting;

public sealed class RigValidatorTests
{
    [Fact]
    public void A_valid_rig_has_no_findings()
    {
        Assert.Empty(Examine(new StandingRig()));
        Assert.Empty(Examine(new StandingRig().WithAxes(new Random(1))));
        for (int seed = 0; seed < 50; seed++)
            Assert.All(Examine(StandingRig.Random(new Random(seed))), issue => Assert.Equal(RigSeverity.Note, issue.Severity));
    }

    [Fact]
    public void The_default_body_is_a_valid_rig()
    {
        foreach (SkeletonVariant variant in new[] { SkeletonVariant.Neck1, SkeletonVariant.Spine3 })
        {
            RigNode[] nodes = [.. BoneHierarchy.Bones.ToArray().Select(bone => new RigNode(
                BoneHierarchy.GetName(bone, variant),
                (int?)BoneHierarchy.GetParent(bone, variant) ?? -1,
                UnityAxes.ToUnityPosition(SkeletonBody.GetDefault(variant).GetOffset(bone)),
                Quaternion.Identity))];
            Assert.Empty(RigValidator.Validate(TargetRig.CreateGeneric(nodes, [.. Enumerable.Range(0, 59)])));
        }
    }

    [Theory]
    [InlineData(HumanoidBone.Hips)]
    [InlineData(HumanoidBone.LeftFoot)]
    [InlineData(HumanoidBone.Head)]
    public void A_required_bone_that_is_missing_is_named(HumanoidBone bone)
    {
        (RigNode[] nodes, int[] nodeByBone) = new StandingRig().Build();
        nodeByBone[(int)bone] = -1;
        RigIssue issue = Assert.Single(RigValidator.Validate(nodes, nodeByBone), issue => issue.Severity == RigSeverity.Error);
        Assert.Equal((RigFault.MissingBone, bone, false), (issue.Fault, issue.Bone, issue.CanFix));
        Assert.Contains(HumanoidBones.GetName(bone), issue.Message);
    }

    [Fact]
    public void A_bone_that_is_mapped_twice_is_named()
    {
        (RigNode[] nodes, int[] nodeByBone) = new StandingRig().Build();
        nodeByBone[(int)HumanoidBone.Neck] = nodeByBone[(int)HumanoidBone.Head];
        Assert.Contains(RigValidator.Validate(nodes, nodeByBone), issue => issue is { Fault: RigFault.DuplicateMapping, Severity: RigSeverity.Error, Bone: HumanoidBone.Head });
    }

    [Fact]
    public void Bones_in_the_wrong_order_are_named()
    {
        (RigNode[] nodes, int[] nodeByBone) = new StandingRig().Build();
        (nodeByBone[(int)HumanoidBone.LeftUpperArm], nodeByBone[(int)HumanoidBone.LeftLowerArm]) = (nodeByBone[(int)HumanoidBone.LeftLowerArm], nodeByBone[(int)HumanoidBone.LeftUpperArm]);
        RigIssue issue = Assert.Single(RigValidator.Validate(nodes, nodeByBone), issue => issue.Severity == RigSeverity.Error);
        Assert.Equal((RigFault.InvalidHierarchy, HumanoidBone.LeftLowerArm), (issue.Fault, issue.Bone));
    }

    [Fact]
    public void Names_that_occur_twice_are_named()
    {
        RigIssue issue = Assert.Single(Examine(new StandingRig().Rename(HumanoidBone.Jaw, "Head")));
        Assert.Equal((RigFault.DuplicateName, RigSeverity.Warning), (issue.Fault, issue.Severity));
    }

    [Theory]
    [InlineData(float.NaN)]
    [InlineData(0)]
    public void An_invalid_transform_is_named(float scale)
    {
        (RigNode[] nodes, int[] nodeByBone) = new StandingRig().Build();
        nodes[3] = nodes[3] with { Scale = new Vector3(1, scale, 1) };
        RigIssue issue = Assert.Single(RigValidator.Validate(nodes, nodeByBone));
        Assert.Equal((RigFault.InvalidTransform, RigSeverity.Error), (issue.Fault, issue.Severity));
        Assert.Contains(nodes[3].Name, issue.Message);
    }

    [Fact]
    public void Swapped_sides_are_found_by_node_names()
    {
        StandingRig rig = new StandingRig().Rename(HumanoidBone.LeftHand, "Hand.R").Rename(HumanoidBone.RightHand, "Hand.L");
        Assert.Equal(
            [HumanoidBone.LeftHand, HumanoidBone.RightHand],
            Examine(rig).Where(issue => issue is { Fault: RigFault.SidesSwapped, Severity: RigSeverity.Error }).Select(issue => issue.Bone!.Value));
    }

    [Theory]
    [InlineData(true, true, HumanoidBone.LeftUpperLeg)]
    [InlineData(true, false, HumanoidBone.LeftUpperLeg)]
    [InlineData(false, true, HumanoidBone.LeftUpperArm)]
    public void Swapped_sides_are_found_by_foot_direction(bool legs, bool arms, HumanoidBone named)
    {
        StandingRig rig = new StandingRig().WithAxes(new Random(7));
        foreach (HumanoidBone bone in Enumerable.Range(0, 55).Select(i => (HumanoidBone)i))
            rig.Rename(bone, $"Bone{(int)bone:00}");
        (RigNode[] nodes, int[] nodeByBone) = rig.Build();
        BodyParts parts = (legs ? BodyParts.Legs : BodyParts.None) | (arms ? BodyParts.Arms | BodyParts.Fingers : BodyParts.None);
        int[] swapped = [.. nodeByBone];
        for (int bone = 0; bone < 55; bone++)
        {
            string name = HumanoidBones.GetName((HumanoidBone)bone);
            if ((HumanoidBones.GetPart((HumanoidBone)bone) & parts) != BodyParts.None && name.StartsWith("Left", StringComparison.Ordinal))
            {
                int right = Array.FindIndex(Enumerable.Range(0, 55).ToArray(), i => HumanoidBones.GetName((HumanoidBone)i) == "Right" + name[4..]);
                (swapped[bone], swapped[right]) = (nodeByBone[right], nodeByBone[bone]);
            }
        }

        RigIssue issue = Assert.Single(RigValidator.Validate(nodes, swapped));
        Assert.Equal((RigFault.SidesSwapped, named), (issue.Fault, issue.Bone));
    }

    [Theory]
    [InlineData(HumanoidBone.LeftUpperArm, 45, 0, 0, 1)]
    [InlineData(HumanoidBone.RightUpperArm, 80, 0, 0, -1)]
    [InlineData(HumanoidBone.RightLowerArm, 30, 0, 1, 0)]
    [InlineData(HumanoidBone.LeftUpperLeg, 20, 0, 0, -1)]
    [InlineData(HumanoidBone.LeftLowerLeg, 40, 1, 0, 0)]
    [InlineData(HumanoidBone.LeftFoot, 40, 0, 1, 0)]
    [InlineData(HumanoidBone.RightHand, 50, 0, 0, 1)]
    [InlineData(HumanoidBone.LeftIndexProximal, 60, 0, 0, 1)]
    public void A_misdirected_limb_is_named_with_its_angle_and_corrected(HumanoidBone bone, float degrees, float x, float y, float z)
    {
        StandingRig rig = new StandingRig().WithAxes(new Random(4)).Turn(bone, new Vector3(x, y, z), degrees);
        RigIssue issue = Assert.Single(Examine(rig), issue => issue.Fault == RigFault.NotInTPose);
        Assert.Equal((bone, true, RigSeverity.Warning), (issue.Bone, issue.CanFix, issue.Severity));
        Assert.InRange(issue.Degrees, degrees - 4, degrees + 4);
        Assert.Contains(HumanoidBones.GetName(bone), issue.Message);
        AssertFixed(rig);
    }

    [Fact]
    public void A_misdirected_palm_is_named_and_turned_down()
    {
        StandingRig rig = new StandingRig().Turn(HumanoidBone.LeftHand, Vector3.UnitX, 90).Turn(HumanoidBone.RightHand, Vector3.UnitX, -60);
        Assert.Equal(
            [(RigFault.PalmNotDown, HumanoidBone.LeftHand, 90), (RigFault.PalmNotDown, HumanoidBone.RightHand, 60)],
            Examine(rig).Select(issue => (issue.Fault, issue.Bone!.Value, (int)MathF.Round(issue.Degrees))));
        AssertFixed(rig);
    }

    [Fact]
    public void Hanging_arms_become_a_T_pose_with_palms_down()
    {
        StandingRig rig = new StandingRig().Turn(HumanoidBone.LeftUpperArm, Vector3.UnitZ, 82).Turn(HumanoidBone.RightUpperArm, Vector3.UnitZ, -82);
        Assert.Equal(2, Examine(rig).Count);
        TargetRig right = AssertFixed(rig);
        var plain = new StandingRig();
        foreach (HumanoidBone bone in new[] { HumanoidBone.LeftHand, HumanoidBone.RightHand, HumanoidBone.LeftLittleDistal, HumanoidBone.RightThumbDistal })
            Assert.True(Vector3.Distance(plain.At(bone), right.RestPositions[right.GetNode(bone)]) < 0.02f, $"{bone}");
    }

    [Theory]
    [InlineData(180)]
    [InlineData(90)]
    [InlineData(-35)]
    public void A_misdirected_figure_is_named_and_turned(float degrees)
    {
        StandingRig rig = new StandingRig().WithAxes(new Random(4)).Turn(HumanoidBone.Hips, Vector3.UnitY, degrees);
        RigIssue issue = Assert.Single(Examine(rig));
        Assert.Equal((RigFault.NotFacingForward, true), (issue.Fault, issue.CanFix));
        Assert.Equal(Math.Abs(degrees), issue.Degrees, 0.5f);
        AssertFixed(rig);
    }

    [Theory]
    [InlineData(1, 0, 0, 90)]
    [InlineData(1, 0, 0, -90)]
    [InlineData(0, 0, 1, 40)]
    [InlineData(1, 1, 1, 120)]
    public void A_lying_figure_is_named_and_raised(float x, float y, float z, float degrees)
    {
        StandingRig rig = new StandingRig().WithAxes(new Random(4)).Turn(HumanoidBone.Hips, new Vector3(x, y, z), degrees);
        Assert.Contains(Examine(rig), issue => issue is { Fault: RigFault.NotUpright, CanFix: true });
        AssertFixed(rig);
    }

    [Fact]
    public void Coincident_joints_are_named()
    {
        StandingRig rig = new StandingRig();
        rig.Move(HumanoidBone.LeftFoot, rig.At(HumanoidBone.LeftLowerLeg) - rig.At(HumanoidBone.LeftFoot));
        Assert.Contains(Examine(rig), issue => issue is { Fault: RigFault.ZeroLengthBone, Bone: HumanoidBone.LeftLowerLeg });
    }

    [Fact]
    public void A_turned_and_scaled_root_is_a_note_and_a_sheared_one_a_warning()
    {
        StandingRig rig = new StandingRig();
        rig.Above.Add(new RigNode("Armature", -1, Vector3.Zero, Quaternion.CreateFromAxisAngle(Vector3.UnitX, -MathF.PI / 2), new Vector3(0.01f)));
        Assert.Equal([RigFault.RootRotated, RigFault.Scaled], Examine(rig).Select(issue => issue.Fault));
        Assert.All(Examine(rig), issue => Assert.Equal((RigSeverity.Note, false), (issue.Severity, issue.CanFix)));

        (RigNode[] nodes, int[] nodeByBone) = new StandingRig().WithAxes(new Random(1)).Build();
        nodes[0] = nodes[0] with { Scale = new Vector3(1.02f, 1, 1) };
        Assert.Contains(RigValidator.Validate(nodes, nodeByBone), issue => issue is { Fault: RigFault.Scaled, Severity: RigSeverity.Warning });
    }

    [Theory]
    [InlineData(0.3f)]
    [InlineData(-0.9f)]
    public void Feet_off_the_ground_are_named(float height)
    {
        RigIssue issue = Assert.Single(Examine(new StandingRig().Move(HumanoidBone.Hips, new Vector3(0, height, 0))));
        Assert.Equal((RigFault.NotOnGround, RigSeverity.Warning, false), (issue.Fault, issue.Severity, issue.CanFix));
    }

    [Fact]
    public void Every_rest_pose_is_corrected()
    {
        int examined = 0;
        for (int seed = 0; seed < 200; seed++)
        {
            var random = new Random(seed);
            StandingRig rig = StandingRig.Random(random);
            foreach (HumanoidBone bone in TPoseSegment.All.Select(segment => segment.Bone))
            {
                bool isFoot = bone is HumanoidBone.LeftFoot or HumanoidBone.RightFoot;
                if (random.Next(3) == 0)
                    rig.Turn(bone, isFoot ? Vector3.UnitY : random.Direction(), random.Range(0, isFoot ? 60 : 100));
            }

            if (random.Next(2) == 0)
                rig.Turn(HumanoidBone.Hips, random.Direction(), random.Range(0, 180));

            // Crossed legs or feet that point backwards look like another fault.
            if (Examine(rig).Any(issue => issue.Fault == RigFault.SidesSwapped))
                continue;

            AssertFixed(rig);
            examined++;
        }

        Assert.True(examined > 100, $"{examined}");
    }

    [Fact]
    public void A_rig_in_T_pose_is_unchanged()
    {
        TargetRig rig = StandingRig.Random(new Random(2)).Create();
        Assert.Same(rig, TPose.Enforce(rig));
    }

    [Fact]
    public void Findings_are_sorted_by_severity()
    {
        (RigNode[] nodes, int[] nodeByBone) = new StandingRig().Rename(HumanoidBone.Jaw, "Head").Build();
        nodeByBone[(int)HumanoidBone.LeftHand] = -1;
        Assert.Equal([RigFault.MissingBone, RigFault.DuplicateName], RigValidator.Validate(nodes, nodeByBone).Select(issue => issue.Fault));
        Assert.Throws<ArgumentException>(() => RigValidator.Validate(nodes, nodeByBone.AsSpan(1)));
        nodeByBone[3] = nodes.Length;
        Assert.Throws<ArgumentException>(() => RigValidator.Validate(nodes, nodeByBone));
        Assert.Throws<ArgumentException>(() => RigValidator.Validate([nodes[1]], [.. Enumerable.Repeat(-1, 55)]));
    }

    private static IReadOnlyList<RigIssue> Examine(StandingRig rig)
    {
        (RigNode[] nodes, int[] nodeByBone) = rig.Build();
        return RigValidator.Validate(nodes, nodeByBone);
    }

    private static TargetRig AssertFixed(StandingRig rig)
    {
        TargetRig right = TPose.Enforce(rig.Create());
        IEnumerable<RigIssue> left = RigValidator.Validate(right).Where(issue => issue.Severity != RigSeverity.Note);
        Assert.True(!left.Any(), string.Join(Environment.NewLine, left));
        return right;
    }
}
