using System.Numerics;
using NeuronMocap.Calculation;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Server;

namespace NeuronMocap.Data.Tests.Calculation;

public sealed class CalculationSourceTests
{
    private const string Take = "hiphop_up_Char00.calc";

    // The four decimals of the text are those of the file, so both formats carry every bit.
    [Theory]
    [InlineData(BroadcastFormat.Binary, Take)]
    [InlineData(BroadcastFormat.Text, Take)]
    [InlineData(BroadcastFormat.Binary, "MasterLiuPerformanceChar00.calc")]
    [InlineData(BroadcastFormat.Text, "MasterLiuPerformanceChar00.calc")]
    public async Task Frames_of_the_file_and_the_stream_are_equal(BroadcastFormat format, string take)
    {
        CalculationDocument document = CalculationDocument.Load(Fixtures.Require("calc", take));
        List<CalculationFrame> received = await CalculationBroadcast.ReceiveAsync(document, format);

        Assert.Equal(document.FrameCount, received.Count);
        for (int i = 0; i < received.Count; i++)
            CalculationBroadcast.AssertEqual(document.GetFrame(i), received[i]);
    }

    [Fact]
    public void A_take_is_a_motion_source()
    {
        CalculationDocument document = CalculationDocument.Load(Fixtures.Require("calc", Take), new CalculationReadOptions { FrameRate = 60 });
        var source = new CalculationSource(document);
        var offsets = new Vector3[BoneHierarchy.BoneCount];
        var ends = new Vector3[BoneHierarchy.BoneCount];
        var pose = new BoneTransform[BoneHierarchy.BoneCount];

        source.GetBody(offsets, ends);
        source.GetPose(100, pose);

        Assert.Equal((60, 172L, SkeletonVariant.Spine3), (source.FrameRate, source.FrameCount, source.Variant));
        Assert.Equal(document.GetFrame(60).FootContacts, source.GetFootContacts(60));
        Assert.Equal(offsets[(int)Bone.LeftArm], pose[(int)Bone.LeftArm].Position);
        Assert.True(ends[(int)Bone.LeftFoot].Z > 20);
        Assert.True(ends[(int)Bone.Head].Y > 10);
    }

    // The inputs of the poses can be computed back from them: positions by the synthesizer, and velocities from positions.
    [Fact]
    public void The_synthesizer_reproduces_the_files_positions()
    {
        CalculationDocument document = CalculationDocument.Load(Fixtures.Require("calc", Take));
        var source = new CalculationSource(document);
        float[] values = new float[CalculationFrame.FullValueCount];
        Vector3 up = new(0, 0, source.Skeleton.GroundHeight / CalculationAxes.CentimetresPerMetre);
        double squares = 0;
        double errors = 0;
        for (int i = 1; i < document.FrameCount - 1; i++)
        {
            CalculationSynthesizer.Write(source, i, values);
            CalculationAxes.Export.ConvertFromBvh(values);
            var made = new CalculationFrame(new(), values);
            CalculationFrame recorded = document.GetFrame(i);
            foreach (Bone bone in (Bone[])[Bone.Hips, Bone.RightUpLeg, Bone.LeftArm, Bone.RightForeArm, Bone.Spine1, Bone.Neck1])
            {
                Assert.InRange((made.GetPosition(bone) - up - recorded.GetPosition(bone)).Length(), 0, 0.006f);
                squares += recorded.GetVelocity(bone).LengthSquared();
                errors += (made.GetVelocity(bone) - recorded.GetVelocity(bone)).LengthSquared();
            }
        }

        // The recorded velocities are filtered, and delayed by one frame.
        Assert.InRange(Math.Sqrt(errors / squares), 0, 0.5);
    }
}
