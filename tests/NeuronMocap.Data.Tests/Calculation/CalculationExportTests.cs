using System.Numerics;
using NeuronMocap.Bvh;
using NeuronMocap.Calculation;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Data.Tests.Calculation;

public sealed class CalculationExportTests
{
    // In this take, the left arm moves and its shoulder blade hardly does, so what is known of the shoulder blade comes from the arm.
    [Fact]
    public void A_recorded_arm_keeps_its_lengths_through_an_export()
    {
        var source = new BvhSource(BvhDocument.Load(Fixtures.Require("test-take", "test.bvh")));
        using var text = new MemoryStream();
        using (var writer = new CalculationFileWriter(text, CalculationFrame.BodyValueCount, leaveOpen: true))
            CalculationExport.Write(source, writer);
        SkeletonBody found = new CalculationSource(CalculationDocument.Parse(text.ToArray())).Skeleton.Body;
        var offsets = new Vector3[BoneHierarchy.BoneCount];
        source.GetBody(offsets, new Vector3[BoneHierarchy.BoneCount]);

        foreach (Bone bone in (Bone[])[Bone.LeftArm, Bone.LeftForeArm, Bone.LeftHand])
            Assert.Equal(offsets[(int)bone].Length(), found.GetOffset(bone).Length(), tolerance: 1.0);
    }
}
