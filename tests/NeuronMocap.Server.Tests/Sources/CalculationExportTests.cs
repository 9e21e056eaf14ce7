using System.Numerics;
using NeuronMocap.Bvh;
using NeuronMocap.Calculation;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Server.Sources;

namespace NeuronMocap.Server.Tests.Sources;

public sealed class CalculationExportTests
{
    [Fact]
    public void A_bvh_take_becomes_a_file_like_a_recording()
    {
        var source = new BvhSource(BvhDocument.Parse(NeuronTake.Write(300)));
        var progress = new Reports();
        using var text = new MemoryStream();
        using (var writer = new CalculationFileWriter(text, CalculationFrame.FullValueCount, leaveOpen: true))
            CalculationExport.Write(source, writer, progress);

        var document = CalculationDocument.Parse(text.ToArray(), new CalculationReadOptions { Strict = true });
        CalculationFrame frame = document.GetFrame(0);

        Assert.Equal(300, document.FrameCount);
        Assert.Equal([256L, 300L], progress.Values);
        Assert.All(
            System.Text.Encoding.ASCII.GetString(text.ToArray()).Split('\n', StringSplitOptions.RemoveEmptyEntries),
            line => Assert.All(line.Split('\t')[..^1], (word, column) => Assert.Matches(column is 336 or 337 ? "^[01]$" : @"^-?\d+\.\d{4}$", word)));

        // The hips are at the origin, and z points down.
        Assert.Equal(Vector3.Zero, frame.GetPosition(Bone.Hips));
        Assert.True(frame.GetPosition(Bone.Head).Z < -0.3f);
        Assert.True(frame.GetPosition(Bone.LeftFoot).Z > 0.5f);
        Assert.True(frame.GetPosition(Bone.LeftUpLeg).X > frame.GetPosition(Bone.RightUpLeg).X);
    }

    // A round trip: poses computed from the export put every bone's centre where the take had it.
    [Fact]
    public void An_exported_actor_moves_the_same_way()
    {
        var actor = new SyntheticSource();
        var source = new FormulaSource(actor.FrameRate, 600, actor.GetPose);
        using var text = new MemoryStream();
        using (var writer = new CalculationFileWriter(text, CalculationFrame.FullValueCount, leaveOpen: true))
            CalculationExport.Write(source, writer);
        var again = new CalculationSource(CalculationDocument.Parse(text.ToArray()));

        var expected = new BoneTransform[BoneHierarchy.BoneCount];
        var actual = new BoneTransform[BoneHierarchy.BoneCount];
        source.GetPose(0, expected);
        float hipsHeight = expected[0].Position.Y;
        var sums = new Dictionary<Bone, double>();
        for (int frame = 0; frame < 600; frame += 7)
        {
            source.GetPose(frame, expected);
            again.GetPose(frame, actual);
            ForwardKinematics.ToWorld(expected, expected, source.Variant);
            ForwardKinematics.ToWorld(actual, actual, again.Variant);
            foreach (Bone bone in (Bone[])[Bone.RightLeg, Bone.LeftLeg, Bone.RightForeArm, Bone.LeftForeArm, Bone.RightHand, Bone.LeftHand])
            {
                Vector3 place = actual[(int)bone].Position + ((again.Skeleton.GroundHeight + hipsHeight) * Vector3.UnitY);
                double error = (place - expected[(int)bone].Position).Length();
                sums[bone] = sums.GetValueOrDefault(bone) + (error / 86);
            }
        }

        Assert.True(sums.Values.All(mean => mean < 1), string.Join(", ", sums));
    }

    [Fact]
    public void A_performance_without_an_end_is_refused()
    {
        using var writer = new CalculationFileWriter(new MemoryStream(), CalculationFrame.FullValueCount);
        Assert.Throws<ArgumentException>(() => CalculationExport.Write(new SyntheticSource(), writer));
    }

    [Fact]
    public void Cancelled_work_ends()
    {
        var source = new BvhSource(BvhDocument.Parse(NeuronTake.Write(3)));
        using var writer = new CalculationFileWriter(new MemoryStream(), CalculationFrame.BodyValueCount);
        Assert.Throws<OperationCanceledException>(
            () => CalculationExport.Write(source, writer, cancellationToken: new CancellationToken(canceled: true)));
        Assert.Equal(0, writer.FrameCount);
    }

    private sealed class Reports : IProgress<long>
    {
        public List<long> Values { get; } = [];

        public void Report(long value) => Values.Add(value);
    }
}
