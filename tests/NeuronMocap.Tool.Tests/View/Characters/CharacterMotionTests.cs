using System.Numerics;
using NeuronMocap.Retargeting;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Infrastructure;
using NeuronMocap.Tests.Retargeting;
using NeuronMocap.Tool.View.Characters;

namespace NeuronMocap.Tool.Tests.View.Characters;

// Poses after encoding and decoding, in the nodes of the file.
public sealed class CharacterMotionTests
{
    // The rotations of a pose have steps of 0.01 degrees, which add up along the limbs.
    private const float Rounding = 0.001f;

    // In the rigs of the tests, knees and elbows are slightly bent. Straightening takes a limb that is off as a whole for straight.
    private const float Straightened = 0.03f;

    public static TheoryData<string> Rigs => [.. RigSkeleton.All];

    [Theory]
    [InlineData(SkeletonVariant.Neck1)]
    [InlineData(SkeletonVariant.Spine3)]
    public void The_performers_own_skeleton_moves_exactly_as_the_performer(SkeletonVariant variant)
    {
        SkeletonBody body = SkeletonBody.Standing(SkeletonBody.GetDefault(variant).Offsets.ToArray(), default, variant);
        CharacterNode[] nodes = Characters.OfBody(body);
        var rig = CharacterRig.Create(nodes, variant: variant);
        Assert.Empty(rig.Problems);
        Assert.Equal(BoneHierarchy.BoneCount, rig.Bones.Length);
        BoneTransform[] pose = Characters.Pose(body);
        BoneTransform[] expected = Characters.WorldOf(pose, body);
        Matrix4x4[] world = Characters.Move(nodes, rig, body, pose).World();
        foreach (Bone bone in BoneHierarchy.Bones)
            Characters.AssertNear(expected[(int)bone].Position, world[(int)bone].Translation, Rounding, $"{bone}");
    }

    [Theory]
    [MemberData(nameof(Rigs))]
    public void Characters_of_other_programs_are_where_the_retargeter_puts_them(string name)
    {
        CharacterNode[] nodes = Characters.OfRig(name);
        var rig = CharacterRig.Create(nodes);
        Assert.Empty(rig.Problems);
        SkeletonBody body = SkeletonBody.GetDefault();
        BoneTransform[] pose = Characters.Pose(body);
        BoneTransform[] performer = Characters.WorldOf(pose, body);
        var expected = new RetargetedPose(rig.Target);
        Assert.True(new Retargeter(rig.Target, body).TryRetarget(pose, expected));
        expected.UpdateWorld();

        Matrix4x4[] world = Characters.Move(nodes, rig, body, pose).World();
        foreach (CharacterBone bone in rig.Bones)
        {
            Vector3 place = expected.WorldPositions[bone.Node];
            Characters.AssertNear(place with { X = -place.X }, world[bone.Node].Translation, Rounding, nodes[bone.Node].Name);

            // These rigs are not turned at rest.
            Quaternion turn = performer[(int)bone.Source].Rotation;
            Vector3 side = Vector3.TransformNormal(Vector3.UnitX, world[bone.Node]);
            Characters.AssertNear(Vector3.Transform(Vector3.UnitX, turn), side, Rounding, nodes[bone.Node].Name);
        }
    }

    [Theory]
    [InlineData("mixamo")]
    [InlineData("ready-player-me")]
    [InlineData("vroid")]
    public void An_A_pose_makes_no_difference(string name)
    {
        CharacterNode[] nodes = Characters.OfRig(name);
        var down = Quaternion.CreateFromAxisAngle(Vector3.UnitZ, -0.8f);
        string Arm(string side) => nodes.First(node => node.Name.Contains(side, StringComparison.Ordinal)
            && (node.Name.EndsWith("Arm", StringComparison.Ordinal) || node.Name.EndsWith("UpperArm", StringComparison.Ordinal))
            && !node.Name.Contains("Fore", StringComparison.Ordinal) && !node.Name.Contains("Lower", StringComparison.Ordinal)).Name;
        string left = name == "vroid" ? "_L_" : "Left";
        string right = name == "vroid" ? "_R_" : "Right";
        CharacterNode[] lowered = Characters.Turned(nodes, (Arm(left), down), (Arm(right), Quaternion.Conjugate(down)));
        AssertSameMotion(nodes, lowered, Straightened);
    }

    [Fact]
    public void A_character_that_faces_backwards_follows_the_performer()
    {
        CharacterNode[] nodes = Characters.Under(new CharacterNode("Scene", -1, Vector3.Zero), Characters.OfRig("vroid"));
        CharacterNode[] back = [nodes[0] with { Rotation = Characters.HalfTurn }, .. nodes[1..]];
        AssertSameMotion(nodes, back);
    }

    [Fact]
    public void Centimetres_under_a_turned_and_scaled_root_are_metres()
    {
        // Mixamo's FBX as GLB: centimetres with Z up, below an armature that is scaled and turned.
        var standing = Quaternion.CreateFromAxisAngle(Vector3.UnitX, -MathF.PI / 2);
        CharacterNode[] nodes = Characters.OfRig("mixamo");
        CharacterNode[] scaled =
        [
            .. nodes.Select((node, i) => node.Parent switch
            {
                -1 => node with { Rotation = standing, Scale = new Vector3(0.01f) },
                0 => node with
                {
                    Translation = Vector3.Transform(node.Translation * 100, Quaternion.Conjugate(standing)),
                    Rotation = Quaternion.Conjugate(standing),
                },
                _ => node with { Translation = node.Translation * 100 },
            }),
        ];
        AssertSameMotion(nodes, scaled);
        DecodedPose pose = Characters.Move(scaled, CharacterRig.Create(scaled), SkeletonBody.GetDefault(), Characters.Pose(SkeletonBody.GetDefault()));
        Assert.InRange(pose.World()[1].Translation.Length(), 1, 5);
    }

    [Fact]
    public void A_figure_that_lies_or_stands_elsewhere_comes_to_the_performer()
    {
        CharacterNode[] nodes = Characters.Under(new CharacterNode("Scene", -1, Vector3.Zero), Characters.OfRig("mixamo"));
        var elsewhere = new CharacterNode("Scene", -1, new Vector3(3, 0, -2));
        AssertSameMotion(nodes, [elsewhere, .. nodes[1..]]);

        // Z up, and no node above the bones that corrects it.
        CharacterNode[] lying = [nodes[0] with { Rotation = Quaternion.CreateFromAxisAngle(Vector3.UnitX, MathF.PI / 2) }, .. nodes[1..]];
        SkeletonBody body = SkeletonBody.GetDefault();
        BoneTransform[] pose = Characters.Pose(body);
        Matrix4x4[] expected = Characters.Move(nodes, CharacterRig.Create(nodes), body, pose).World();
        Matrix4x4[] actual = Characters.Move(lying, CharacterRig.Create(lying), body, pose).World();
        Vector3 difference = actual[2].Translation - expected[2].Translation;
        Assert.InRange(difference.Length(), 0, 0.05f);
        for (int node = 2; node < nodes.Length; node++)
            Characters.AssertNear(expected[node].Translation + difference, actual[node].Translation, Straightened, nodes[node].Name);
    }

    [Fact]
    public void The_lowest_point_of_the_figure_stands_on_the_ground()
    {
        CharacterNode[] nodes = Characters.OfRig("mixamo");
        CharacterNode[] raised = [nodes[0] with { Translation = new Vector3(0, 0.4f, 0) }, .. nodes[1..]];
        CharacterNode[] hanging = [nodes[0] with { Translation = new Vector3(0, -1, 0) }, .. nodes[1..]];
        Assert.Equal(CharacterRig.Create(nodes, lowest: 0).Target.HipsHeight, CharacterRig.Create(raised, lowest: 0.4f).Target.HipsHeight, 1e-5f);

        // Without the figure, a tenth of the leg is below the ankles.
        Assert.Equal(1, CharacterRig.Create(nodes).Target.HipsHeight, 1e-5f);
        Assert.InRange(CharacterRig.Create(hanging).Target.HipsHeight, 0.95f, 1.05f);
    }

    [Fact]
    public void A_planted_foot_stays_where_it_is()
    {
        CharacterNode[] nodes = Characters.OfRig("mixamo");
        var rig = CharacterRig.Create(nodes, lowest: 0);
        SkeletonBody body = SkeletonBody.GetDefault();
        var poser = new CharacterPoser(rig, body);
        int foot = rig.Target.GetNode(HumanoidBone.LeftFoot);
        var pose = new BoneTransform[BoneHierarchy.BoneCount];
        body.CopyRestPose(pose);
        List<Vector3> places = [];
        for (int frame = 0; frame < 60; frame++)
        {
            pose[0] = pose[0] with { Position = pose[0].Position + new Vector3(0, 0, 0.1f) };
            Assert.True(poser.TryTake(pose, new FootContacts(true, false), frame / 60.0));
            places.Add(poser.Pose.WorldPositions[foot]);
        }

        Assert.InRange(Math.Abs(places[^1].Z - places[0].Z), 0, 0.001f);
        Assert.InRange(poser.Pose.WorldPositions[rig.HipsNode].Z, 0.05f, 0.07f);
    }

    [Fact]
    public void A_frame_allocates_nothing_and_is_small()
    {
        SkeletonBody body = SkeletonBody.GetDefault();
        var rig = CharacterRig.Create(Characters.OfBody(body));
        var poser = new CharacterPoser(rig, body);
        BoneTransform[] pose = Characters.Pose(body);
        byte[] bytes = new byte[CharacterPose.MaxSize];
        Assert.InRange(CharacterPose.MaxSize, 1, 500);
        double time = 0;
        Allocations.AssertNone(() =>
        {
            poser.TryTake(pose, new FootContacts(true, true), time += 0.01);
            CharacterPose.Encode(rig, poser.Pose, 1, 2, bytes);
        });
    }

    [Fact]
    public void A_broken_frame_leaves_the_pose()
    {
        SkeletonBody body = SkeletonBody.GetDefault();
        var poser = new CharacterPoser(CharacterRig.Create(Characters.OfBody(body)), body);
        BoneTransform[] pose = Characters.Pose(body);
        Assert.True(poser.TryTake(pose, default, 0));
        Vector3 hips = poser.Pose.HipsLocalPosition;
        pose[5] = new BoneTransform(pose[5].Position, new Quaternion(float.NaN, 0, 0, 1));
        Assert.False(poser.TryTake(pose, default, 0.01));
        Assert.Equal(hips, poser.Pose.HipsLocalPosition);
    }

    // The joints of two characters with the same bones.
    private static void AssertSameMotion(CharacterNode[] expected, CharacterNode[] actual, float tolerance = Rounding)
    {
        SkeletonBody body = SkeletonBody.GetDefault();
        BoneTransform[] pose = Characters.Pose(body, 3);
        var rig = CharacterRig.Create(expected);
        var other = CharacterRig.Create(actual);
        Assert.Equal(rig.Bones.ToArray(), other.Bones.ToArray());
        Matrix4x4[] one = Characters.Move(expected, rig, body, pose).World();
        Matrix4x4[] two = Characters.Move(actual, other, body, pose).World();
        foreach (CharacterBone bone in rig.Bones)
            Characters.AssertNear(one[bone.Node].Translation, two[bone.Node].Translation, tolerance, expected[bone.Node].Name);
    }
}
