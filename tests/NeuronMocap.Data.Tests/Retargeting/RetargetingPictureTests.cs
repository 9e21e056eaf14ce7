using System.Numerics;
using NeuronMocap.Bvh;
using NeuronMocap.Motion;
using NeuronMocap.Retargeting;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Retargeting;
using NeuronMocap.Tests.Retargeting.Pictures;

namespace NeuronMocap.Data.Tests.Retargeting;

/// <summary>
/// The picture of docs/guide/retargeting.md: ten frames of a recorded take, with the actor beside a very different character.
/// </summary>
public sealed class RetargetingPictureTests
{
    /// <summary>Draws the picture again instead of comparing it.</summary>
    private const string UpdateVariable = "NEURONMOCAP_UPDATE_PICTURES";

    private const int Columns = 5;
    private const int CellWidth = 232;
    private const int CellHeight = 214;

    [Fact]
    public void The_picture_shows_the_character_in_the_actors_pose()
    {
        var source = new BvhSource(BvhDocument.Load(Fixtures.Require("test-take", "test.bvh")));
        var drawing = new SvgDrawing(Columns * CellWidth, (3 * CellHeight) + 10);
        var figures = new FigureDrawing(drawing);
        SkeletonBody body = BodyOf(source);
        TargetRig made = StrangeRig().Create();
        TargetRig rig = TPose.Enforce(made);
        var stage = new Stage(rig, body);
        DrawRest(drawing, figures, body, made, rig);

        int next = 0;
        int frames = checked((int)source.FrameCount!.Value);
        BoneTransform[] pose = new BoneTransform[BoneHierarchy.BoneCount];
        for (int frame = 0; frame < frames && next < 10; frame++)
        {
            source.GetPose(frame, pose);
            stage.Show(pose, frame / source.FrameRate);
            if (frame != (int)((next + 0.5) / 10 * frames))
                continue;

            AssertSameDirections(stage, frame);
            Vector2 corner = CornerOf(Columns + next);
            figures.Actor(corner + new Vector2(58, CellHeight - 30), stage.World, body);
            figures.Character(corner + new Vector2(170, CellHeight - 30), stage.Pose, withAxes: false);
            drawing.Words(corner + new Vector2(CellWidth / 2, CellHeight - 4), FormattableString.Invariant($"{frame / source.FrameRate:0.0} s"));
            next++;
        }

        Assert.Equal(10, next);
        Compare(drawing.ToString());
    }

    [Fact]
    public void A_moved_joint_changes_the_picture()
    {
        static string Draw(float x)
        {
            var drawing = new SvgDrawing(10, 10);
            drawing.Line(Vector2.Zero, new Vector2(x, 0), "#000000", 1);
            return drawing.ToString();
        }

        Assert.Null(SvgDrawing.Difference(Draw(3), Draw(3.1f)));
        Assert.NotNull(SvgDrawing.Difference(Draw(3), Draw(4)));
        Assert.NotNull(SvgDrawing.Difference(Draw(3), Draw(3).Replace("line", "path")));
    }

    // Short legs, long arms that hang down and are bent, no upper chest, twist bones, and bone axes in every direction. The rig is in centimetres and
    // lies on its back under a node that stands it up, as some programs export it.
    private static StandingRig StrangeRig()
    {
        var rig = new StandingRig(thigh: 0.33f, shin: 0.38f, hips: 0.12f, arm: 0.33f, forearm: 0.3f) { HasTwistNodes = true, TwistAxes = new Random(8).Rotation() };
        rig.Above.Add(new RigNode("Armature", -1, Vector3.Zero, Quaternion.CreateFromAxisAngle(Vector3.UnitX, -MathF.PI / 2), new Vector3(0.01f)));
        return rig.WithAxes(new Random(3))
            .Without(HumanoidBone.UpperChest)
            .Turn(HumanoidBone.LeftUpperArm, Vector3.UnitZ, 68)
            .Turn(HumanoidBone.RightUpperArm, Vector3.UnitZ, -68)
            .Turn(HumanoidBone.LeftLowerArm, Vector3.UnitX, -28)
            .Turn(HumanoidBone.RightLowerArm, Vector3.UnitX, -28)
            .Turn(HumanoidBone.LeftUpperLeg, Vector3.UnitZ, -12)
            .Turn(HumanoidBone.RightUpperLeg, Vector3.UnitZ, 12);
    }

    private static SkeletonBody BodyOf(MotionSource source)
    {
        Vector3[] offsets = new Vector3[BoneHierarchy.BoneCount];
        Vector3[] ends = new Vector3[BoneHierarchy.BoneCount];
        source.GetBody(offsets, ends);
        return new SkeletonBody(offsets, ends, source.Variant);
    }

    private static void DrawRest(SvgDrawing drawing, FigureDrawing figures, SkeletonBody body, TargetRig made, TargetRig rig)
    {
        BoneTransform[] rest = new BoneTransform[BoneHierarchy.BoneCount];
        body.CopyRestPose(rest);
        ForwardKinematics.ToWorld(rest, rest, body.Variant);
        figures.Actor(new Vector2(190, CellHeight - 30), rest, body);
        drawing.Words(new Vector2(190, CellHeight - 4), "the actor at rest");
        figures.Character(new Vector2(520, CellHeight - 30), new RetargetedPose(made), withAxes: true);
        drawing.Words(new Vector2(520, CellHeight - 4), "the character as it was made");
        figures.Character(new Vector2(880, CellHeight - 30), new RetargetedPose(rig), withAxes: true);
        drawing.Words(new Vector2(880, CellHeight - 4), "stood into a T-pose by TPose.Enforce");
    }

    private static Vector2 CornerOf(int cell) => new(cell % Columns * CellWidth, cell / Columns * CellHeight);

    // For the limbs, whose joints both rigs have: both drawings show the same motion.
    private static void AssertSameDirections(Stage stage, int frame)
    {
        foreach (TPoseSegment segment in TPoseSegment.All.Where(segment => segment.Next is not null && !HumanoidBones.IsFinger(segment.Bone) && !segment.IsFoot))
        {
            bool isLeg = HumanoidBones.GetPart(segment.Bone) is BodyParts.LeftLeg or BodyParts.RightLeg;
            float cosine = Vector3.Dot(stage.ActorWay(segment.Bone, segment.Next!.Value), stage.CharacterWay(segment.Bone, segment.Next!.Value));
            float degrees = MathF.Acos(Math.Min(1, cosine)) * 180 / MathF.PI;
            Assert.True(degrees < (isLeg ? 8 : 2.5f), $"Frame {frame}, {segment.Bone}: {degrees} degrees");
        }
    }

    private static void Compare(string svg)
    {
        string path = Repository.PathOf("docs", "guide", "retargeting.svg");
        if (Environment.GetEnvironmentVariable(UpdateVariable) == "1")
            File.WriteAllText(path, svg);

        string? difference = SvgDrawing.Difference(File.ReadAllText(path), svg);
        Assert.True(difference is null, $"docs/guide/retargeting.svg is out of date, run with {UpdateVariable}=1: {difference}");
    }

    private sealed class Stage(TargetRig rig, SkeletonBody body)
    {
        private readonly Retargeter _retargeter = new(rig, body);
        private readonly FootPlanter _planter = new(rig);
        private readonly FootContactEstimator _contacts = new();

        public BoneTransform[] World { get; } = new BoneTransform[BoneHierarchy.BoneCount];

        public RetargetedPose Pose { get; } = new(rig);

        public void Show(BoneTransform[] pose, double seconds)
        {
            ForwardKinematics.ToWorld(pose, World, body.Variant);
            Assert.True(_retargeter.TryRetarget(pose, Pose));
            _planter.Plant(Pose, _contacts.Update(World, body, seconds), seconds);
        }

        public Vector3 ActorWay(HumanoidBone from, HumanoidBone to)
        {
            Vector3 Of(HumanoidBone bone) => World[(int)HumanoidMap.GetBone(bone, body.Variant, rig.Bones)!.Value].Position;
            return Vector3.Normalize(UnityAxes.ToUnityPosition(Of(to) - Of(from)));
        }

        public Vector3 CharacterWay(HumanoidBone from, HumanoidBone to) =>
            Vector3.Normalize(Pose.WorldPositions[rig.GetNode(to)] - Pose.WorldPositions[rig.GetNode(from)]);
    }
}
