using System.Numerics;
using NeuronMocap.Calculation;

namespace NeuronMocap.Tests.Calculation;

public sealed class CalculationSkeletonTests
{
    [Fact]
    public void Poses_reproduce_the_centres_of_the_export()
    {
        CalculationDocument document = ActorExport.Write(240);
        var skeleton = CalculationSkeleton.Measure(document);
        foreach (Bone bone in (Bone[])[Bone.RightLeg, Bone.LeftLeg, Bone.RightForeArm, Bone.LeftForeArm])
        {
            double sum = 0;
            for (int frame = 0; frame < document.FrameCount; frame++)
            {
                BoneTransform[] world = CalculationPoses.WorldOf(skeleton, document, frame);
                Vector3 exported = CalculationAxes.Export.ToBvh(document.GetFrame(frame).GetPosition(bone)) * CalculationAxes.CentimetresPerMetre;
                Vector3 centre = world[(int)bone].TransformPoint(CalculationPoses.EndOf(bone, skeleton.Body) / 2);
                sum += (centre - exported + (skeleton.GroundHeight * Vector3.UnitY)).Length();
            }

            Assert.InRange(sum / document.FrameCount, 0, 1);
        }
    }

    [Fact]
    public void A_take_of_one_frame_has_a_body()
    {
        CalculationDocument whole = ActorExport.Write(240);
        using var text = new MemoryStream();
        using (var writer = new CalculationFileWriter(text, whole.ValueCount, leaveOpen: true))
            writer.WriteFrame(whole.GetValues(100));
        var document = CalculationDocument.Parse(text.ToArray());

        var skeleton = CalculationSkeleton.Measure(document);

        Assert.InRange(skeleton.Body.GetOffset(Bone.LeftUpLeg).Length(), 7, 13);
        Assert.InRange(skeleton.Body.GetOffset(Bone.LeftLeg).Length(), 35, 48);
        Assert.InRange(skeleton.Body.GetOffset(Bone.LeftForeArm).Length(), 22, 31);
        Assert.All(CalculationPoses.WorldOf(skeleton, document, 0), bone => Assert.True(float.IsFinite(bone.Position.X) && float.IsFinite(bone.Rotation.W)));
    }

    [Fact]
    public void Rows_of_zeros_make_finite_poses()
    {
        string zeros = string.Join('\t', Enumerable.Repeat("0.0000", 946)) + "\n";
        var document = CalculationDocument.Parse(CalculationText.Utf8(zeros + zeros));

        BoneTransform[] world = CalculationPoses.WorldOf(CalculationSkeleton.Measure(document), document, 1);

        Assert.All(world, bone => Assert.True(float.IsFinite(bone.Position.Y) && float.IsFinite(bone.Rotation.W)));
    }
}
