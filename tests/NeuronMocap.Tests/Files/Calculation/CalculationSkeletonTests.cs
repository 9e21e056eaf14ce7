using System.Numerics;
using NeuronMocap.Calculation;
using NeuronMocap.Skeleton;

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

    [Theory]
    [InlineData(100)]
    [InlineData(0)]
    public void A_position_that_is_not_a_number_spoils_only_its_own_frame(int spoiled)
    {
        CalculationDocument whole = ActorExport.Write(240);
        CalculationDocument document = Write(Enumerable.Range(0, 240).Select(frame => frame == spoiled ? Without(Row(whole, frame), Bone.RightFoot) : Row(whole, frame)));

        var skeleton = CalculationSkeleton.Measure(document);

        AssertSameBody(CalculationSkeleton.Measure(whole), skeleton);
        foreach (int frame in Enumerable.Range(0, 240).Where(frame => frame != spoiled))
        {
            Assert.All(
                CalculationPoses.WorldOf(skeleton, document, frame),
                static bone => Assert.True(float.IsFinite(bone.Position.Length()) && float.IsFinite(bone.Rotation.Length())));
        }
    }

    // Only every second frame of so many would be measured, and each of those lacks a foot.
    [Fact]
    public void Spoiled_frames_of_a_long_take_are_replaced_by_others()
    {
        CalculationDocument whole = ActorExport.Write(240);
        float[][] rows = [.. Enumerable.Range(0, 240).Select(frame => Row(whole, frame)[..CalculationFrame.BodyValueCount])];
        CalculationDocument document = Write(Enumerable.Range(0, 2002).Select(frame => frame % 2 == 0 ? Without(rows[frame % 240], Bone.RightFoot) : rows[frame % 240]));

        AssertSameBody(CalculationSkeleton.Measure(whole), CalculationSkeleton.Measure(document));
    }

    [Theory]
    [InlineData(Bone.RightFoot)]
    [InlineData(Bone.RightUpLeg, Bone.LeftUpLeg)]
    public void A_take_without_a_whole_frame_is_refused(params Bone[] lost)
    {
        CalculationDocument whole = ActorExport.Write(20);
        CalculationDocument document = Write(Enumerable.Range(0, 20).Select(frame => Without(Row(whole, frame), lost)));

        var refusal = Assert.Throws<CalculationFormatException>(() => CalculationSkeleton.Measure(document));

        Assert.Contains("not a number", refusal.Message, StringComparison.Ordinal);
    }

    private static float[] Row(CalculationDocument document, int frame) => document.GetValues(frame).ToArray();

    private static float[] Without(float[] row, params Bone[] bones)
    {
        float[] copy = [.. row];
        foreach (Bone bone in bones)
            copy[CalculationOrder.IndexOf(bone) * 16] = float.NaN;

        return copy;
    }

    private static CalculationDocument Write(IEnumerable<float[]> rows)
    {
        float[][] all = [.. rows];
        using var text = new MemoryStream();
        using (var writer = new CalculationFileWriter(text, all[0].Length, leaveOpen: true))
        {
            foreach (float[] row in all)
                writer.WriteFrame(row);
        }

        return CalculationDocument.Parse(text.ToArray());
    }

    private static void AssertSameBody(CalculationSkeleton expected, CalculationSkeleton actual)
    {
        Assert.Equal(expected.Body.Variant, actual.Body.Variant);
        Assert.InRange(actual.GroundHeight, expected.GroundHeight - 1, expected.GroundHeight + 1);
        foreach (Bone bone in BoneHierarchy.Bones)
        {
            Assert.InRange(Vector3.Distance(expected.Body.GetOffset(bone), actual.Body.GetOffset(bone)), 0, 1);
            Assert.InRange(Vector3.Distance(expected.Body.EndSites[(int)bone], actual.Body.EndSites[(int)bone]), 0, 1);
        }
    }
}
