using NeuronMocap.Bvh;
using NeuronMocap.Calculation;
using NeuronMocap.Motion;
using NeuronMocap.Retargeting;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Retargeting;

namespace NeuronMocap.Data.Tests.Retargeting;

public sealed class FootPlanterTests
{
    [Fact]
    public void Planted_feet_of_the_recorded_take_stand_still()
    {
        BvhDocument document = BvhDocument.Load(Fixtures.Require("test-take", "test.bvh"));
        Assert.True(BvhSkeletonMap.TryCreate(document, out BvhSkeletonMap? map, out _));
        var source = new BvhSource(document);
        var rig = new StandingRig(thigh: 0.5f, shin: 0.38f, hips: 0.13f, arm: 0.3f, forearm: 0.2f);
        var live = new FootContactEstimator();
        var walk = new FootWalk(rig.Create(), map.GetBody(), source.FrameRate, new RetargetOptions { Scale = 1.3f });
        BoneTransform[] pose = new BoneTransform[BoneHierarchy.BoneCount];
        BoneTransform[] world = new BoneTransform[BoneHierarchy.BoneCount];
        for (int frame = 0; frame < document.FrameCount; frame++)
        {
            source.GetPose(frame, pose);
            ForwardKinematics.ToWorld(pose, world, source.Variant);
            walk.Add(pose, live.Update(world, map.GetBody(), frame / source.FrameRate));
        }

        string figures = walk.Describe("The take");
        Assert.True(walk.LargestSlide(planted: true) < FootWalk.Still && walk.LargestMove(planted: true, after: 0.1) < 0.005f, figures);
        Assert.True(walk.LeastKnee > -1e-4f && walk.LargestAddedSpeed() < 0.6f, figures);
    }

    // Dances and martial arts on one leg, with recorded contacts and with estimated contacts, on a character of other proportions.
    [Theory]
    [InlineData("MasterLiuPerformanceChar00.calc", false, FootRotation.Keep)]
    [InlineData("hiphop_up_Char00.calc", false, FootRotation.Flatten)]
    [InlineData("salsa_left_Char00.calc", false, FootRotation.Keep)]
    [InlineData("salsa_left_Char00.calc", true, FootRotation.Flatten)]
    public void Planted_feet_of_recorded_dances_stand_still(string take, bool estimated, FootRotation rotation)
    {
        CalculationDocument document = CalculationDocument.Load(Fixtures.Require("calc", take));
        var skeleton = CalculationSkeleton.Measure(document);
        var live = new FootContactEstimator();
        var rig = new StandingRig(thigh: 0.4f, shin: 0.46f, hips: 0.12f, arm: 0.3f, forearm: 0.2f) { HasTwistNodes = true };
        var planting = new FootPlanterOptions { FootRotation = rotation };
        var walk = new FootWalk(rig.WithAxes(new Random(1)).Create(), skeleton.Body, document.FrameRate, planting: planting);
        BoneTransform[] pose = new BoneTransform[BoneHierarchy.BoneCount];
        BoneTransform[] world = new BoneTransform[BoneHierarchy.BoneCount];
        for (int frame = 0; frame < document.FrameCount; frame++)
        {
            skeleton.CopyLocalTransforms(document.GetValues(frame), pose);
            ForwardKinematics.ToWorld(pose, world, skeleton.Body.Variant);
            walk.Add(pose, estimated ? live.Update(world, skeleton.Body, frame / document.FrameRate) : document.GetFootContacts(frame));
        }

        string figures = walk.Describe(take);
        Assert.True(walk.LargestSlide(planted: true) < 0.005f && walk.LargestMove(planted: true, after: 0.1) < 0.005f, figures);
        Assert.True(walk.LargestSlide(planted: false) > 0.02f, figures);
        Assert.True(walk.MaxHipsShift <= 0.1001f * walk.Rig.LegLength && walk.LeastKnee > -1e-4f, figures);
        Assert.True(walk.LargestAddedSpeed() < 2 && walk.LargestKneeSpeed < 4 && walk.LargestTurn < 600, figures);
        Assert.True(walk.FramesLetGo == 0, figures);
    }
}
