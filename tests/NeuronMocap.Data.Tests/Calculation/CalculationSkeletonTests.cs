using System.Numerics;
using NeuronMocap.Calculation;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Calculation;

namespace NeuronMocap.Data.Tests.Calculation;

public sealed class CalculationSkeletonTests
{
    private static readonly Bone[] Tracked = [.. CalculationOrder.Bones[..CalculationOrder.BodyBoneCount]];

    public static TheoryData<string> Takes => [.. CalculationText.Takes];

    // Over all bones and frames: 0.17, 0.11 and 0.14 cm on average. The worst is a knee in the first take, where the actor kneels and spins.
    [Theory]
    [InlineData("MasterLiuPerformanceChar00.calc", 0.2, 1.8)]
    [InlineData("hiphop_up_Char00.calc", 0.13, 0.62)]
    [InlineData("salsa_left_Char00.calc", 0.17, 0.8)]
    public void Poses_reproduce_the_recorded_centres(string take, double mean, double max)
    {
        CalculationDocument document = Load(take);
        var skeleton = CalculationSkeleton.Measure(document);
        double sum = 0;
        double worst = 0;
        for (int frame = 0; frame < document.FrameCount; frame++)
        {
            BoneTransform[] world = CalculationPoses.WorldOf(skeleton, document, frame);
            foreach (Bone bone in Tracked)
            {
                Vector3 recorded = CalculationAxes.Export.ToBvh(document.GetFrame(frame).GetPosition(bone)) * CalculationAxes.CentimetresPerMetre;
                Vector3 centre = world[(int)bone].TransformPoint(CalculationPoses.EndOf(bone, skeleton.Body) / 2);
                double error = (centre - recorded + (skeleton.GroundHeight * Vector3.UnitY)).Length();
                sum += error;
                worst = Math.Max(worst, error);
            }
        }

        double average = sum / (document.FrameCount * Tracked.Length);
        Assert.True(average < mean && worst < max, $"Mean {average} cm, largest {worst} cm.");
    }

    [Theory, MemberData(nameof(Takes))]
    public void The_body_has_adult_proportions(string take)
    {
        SkeletonBody body = CalculationSkeleton.Measure(Load(take)).Body;
        BoneDimensions sizes = body.Measure();

        Assert.Equal(SkeletonVariant.Spine3, body.Variant);
        Assert.InRange(sizes.UpperLeg, 0.40f, 0.50f);
        Assert.InRange(sizes.LowerLeg, 0.38f, 0.50f);
        Assert.InRange(sizes.UpperArm, 0.25f, 0.31f);
        Assert.InRange(sizes.Forearm, 0.25f, 0.30f);
        Assert.InRange(body.GetOffset(Bone.Hips).Y, 88, 106);
        Assert.All([Bone.LeftUpLeg, Bone.LeftArm, Bone.LeftForeArm, Bone.LeftHand], bone => Assert.True(body.GetOffset(bone).X > 5));
        foreach (Bone bone in (Bone[])[Bone.LeftLeg, Bone.LeftArm, Bone.LeftForeArm, Bone.LeftHand])
        {
            Bone right = Enum.Parse<Bone>(bone.ToString().Replace("Left", "Right", StringComparison.Ordinal));
            Assert.Equal(body.GetOffset(right).Length(), body.GetOffset(bone).Length(), tolerance: 2);
        }
    }

    [Theory, MemberData(nameof(Takes))]
    public void Bones_keep_their_lengths_and_rotations_are_unit(string take)
    {
        CalculationDocument document = Load(take);
        var skeleton = CalculationSkeleton.Measure(document);
        var pose = new BoneTransform[BoneHierarchy.BoneCount];
        for (int frame = 0; frame < document.FrameCount; frame++)
        {
            skeleton.CopyLocalTransforms(document.GetValues(frame), pose);
            foreach (Bone bone in BoneHierarchy.Bones)
            {
                Assert.Equal(1, pose[(int)bone].Rotation.Length(), tolerance: 1e-4);
                if (bone is not (Bone.Hips or Bone.RightFoot or Bone.LeftFoot))
                    Assert.Equal(skeleton.Body.GetOffset(bone), pose[(int)bone].Position);
            }
        }
    }

    [Theory]
    [InlineData("hiphop_up_Char00.calc")]
    [InlineData("salsa_left_Char00.calc")]
    public void Dancers_stand_upright_and_bend_their_knees_forward(string take)
    {
        CalculationDocument document = Load(take);
        var skeleton = CalculationSkeleton.Measure(document);
        for (int frame = 0; frame < document.FrameCount; frame++)
        {
            BoneTransform[] world = CalculationPoses.WorldOf(skeleton, document, frame);
            Vector3 left = Vector3.Transform(Vector3.UnitX, world[0].Rotation);
            var forward = Vector3.Cross(left, Vector3.UnitY);

            Assert.InRange(world[(int)Bone.Head].Position.Y, 130, 170);
            Assert.True(Vector3.Dot(world[(int)Bone.LeftUpLeg].Position - world[(int)Bone.RightUpLeg].Position, left) > 15);
            foreach (Bone hip in (Bone[])[Bone.RightUpLeg, Bone.LeftUpLeg])
            {
                Vector3 knee = world[(int)hip + 1].Position - ((world[(int)hip].Position + world[(int)hip + 2].Position) / 2);
                Assert.True(Vector3.Dot(knee, forward) > -1.5f, $"Frame {frame}: {hip} bends backward by {-Vector3.Dot(knee, forward)} cm.");
            }

            FootContacts contacts = document.GetFootContacts(frame);
            foreach (Bone foot in (Bone[])[.. contacts.Left ? [Bone.LeftFoot] : Array.Empty<Bone>(), .. contacts.Right ? [Bone.RightFoot] : Array.Empty<Bone>()])
                Assert.InRange(world[(int)foot].TransformPoint(skeleton.Body.EndSites[(int)foot]).Y, -6, 6);
        }
    }

    private static CalculationDocument Load(string take) => CalculationDocument.Load(Fixtures.Require("calc", take));
}
