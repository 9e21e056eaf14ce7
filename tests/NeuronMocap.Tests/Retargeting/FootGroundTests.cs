using System.Numerics;
using NeuronMocap.Retargeting;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Retargeting;

// Changes of the ground and the clock under planted feet.
public sealed class FootGroundTests
{
    private const double Rate = 60;

    private readonly TargetRig _rig = new StandingRig().Create();
    private readonly FootPlanter _planter;
    private readonly Retargeter _retargeter;
    private readonly RetargetedPose _pose;
    private readonly BoneTransform[] _rest = new BoneTransform[BoneHierarchy.BoneCount];

    public FootGroundTests()
    {
        _planter = new FootPlanter(_rig);
        _retargeter = new Retargeter(_rig, SkeletonBody.GetDefault());
        _pose = new RetargetedPose(_rig);
        SkeletonBody.GetDefault().CopyRestPose(_rest);
    }

    [Fact]
    public void Feet_settle_on_the_given_ground_and_hips_follow()
    {
        foreach (float height in new[] { -0.04f, 0, 0.03f })
        {
            FootWalk walk = FootWalk.OfActor(new StandingRig().Create(), Rate, 3, planting: new FootPlanterOptions { GroundHeight = height });
            Assert.Equal(height, walk.Planter.HipsShift, 0.01f);
            (bool left, bool right) = walk.Planter.Planted;
            Assert.True(left || right);
            for (int side = 0; side < 2; side++)
            {
                if (side == 0 ? left : right)
                    Assert.Equal(StandingRig.Ankle + height, walk.Ankle(side, walk.Count - 1).Y, 0.004f);
            }
        }
    }

    [Fact]
    public void The_ground_is_learnt_from_the_feet()
    {
        FootWalk walk = FootWalk.OfActor(
            new StandingRig().Create(), Rate, 8, options: new RetargetOptions { HeightOffset = 0.5f }, planting: new FootPlanterOptions { GroundHeight = null });
        Assert.True(walk.LargestSlide(planted: true) < FootWalk.Still);
        Assert.True(walk.MaxHipsShift < 0.01f, $"{walk.MaxHipsShift}");

        // Half a metre above a fixed ground, the feet stand on something else.
        FootWalk raised = FootWalk.OfActor(new StandingRig().Create(), Rate, 8, options: new RetargetOptions { HeightOffset = 0.5f });
        Assert.True(raised.LargestSlide(planted: true) < FootWalk.Still && raised.MaxHipsShift < 0.01f, raised.Describe("Raised"));
    }

    [Fact]
    public void Changing_the_ground_moves_standing_feet()
    {
        double time = Stand(0, 1);
        foreach (float height in new[] { 0.03f, 0.05f, -0.02f, 0 })
        {
            _planter.Options.GroundHeight = height;
            time = Stand(time, 3);
            AssertStandsAt(height);
        }

        // Feet do not move onto a table.
        _planter.Options.GroundHeight = 1;
        Stand(time, 3);
        AssertStandsAt(0);
    }

    [Fact]
    public void Moving_ground_carries_the_feet()
    {
        double time = Stand(0, 1);
        for (int frame = 1; frame <= 60; frame++)
        {
            _planter.Options.GroundHeight = frame * 0.0005f;
            time = Stand(time, 1 / Rate);
            Assert.Equal(StandingRig.Ankle + _planter.Options.GroundHeight.Value, Ankle(HumanoidBone.LeftFoot), 5e-4f);
        }
    }

    [Fact]
    public void A_restarted_clock_resets_the_planter()
    {
        Stand(100, 1);
        _planter.Options.GroundHeight = 0.03f;
        Stand(0, 1, default(FootContacts));
        Assert.Equal(default, _planter.Planted);
        Stand(1, 3);
        AssertStandsAt(0.03f);
    }

    // A program that stalls may miss all frames of a step, so that the contact seems uninterrupted.
    [Theory]
    [InlineData(0.4)]
    [InlineData(0.9)]
    public void A_step_within_missed_frames_is_a_step(double missed)
    {
        var actor = new SyntheticSource(Rate);
        int gap = (int)(missed * Rate);
        for (int last = 30; last < 300; last += 7)
        {
            _planter.Reset();
            for (int frame = last - 20; frame <= last; frame++)
                Plant(actor, frame);

            for (int frame = last + gap; frame < last + gap + 8; frame++)
            {
                (Vector3 left, Vector3 right) = Plant(actor, frame);
                Assert.Equal(actor.GetFootContacts(frame), _planter.Planted);

                // At or below the limit, the foot still stands.
                float longest = 0.1f * _rig.LegLength;
                Assert.InRange((Place(HumanoidBone.LeftFoot) - left).Length(), 0, longest);
                Assert.InRange((Place(HumanoidBone.RightFoot) - right).Length(), 0, longest);
            }
        }
    }

    private double Stand(double from, double seconds, FootContacts? contacts = null)
    {
        int frames = (int)Math.Round(seconds * Rate);
        for (int frame = 0; frame < frames; frame++)
        {
            Assert.True(_retargeter.TryRetarget(_rest, _pose));
            _planter.Plant(_pose, contacts ?? new FootContacts(Left: true, Right: true), from + (frame / Rate));
        }

        return from + seconds;
    }

    private void AssertStandsAt(float height)
    {
        Assert.Equal(new FootContacts(Left: true, Right: true), _planter.Planted);
        Assert.Equal(StandingRig.Ankle + height, Ankle(HumanoidBone.LeftFoot), 1e-3f);
        Assert.Equal(StandingRig.Ankle + height, Ankle(HumanoidBone.RightFoot), 1e-3f);
        Assert.Equal(height, _planter.HipsShift, 3e-3f);
    }

    // The positions of the feet without planting.
    private (Vector3 Left, Vector3 Right) Plant(SyntheticSource actor, int frame)
    {
        BoneTransform[] source = new BoneTransform[BoneHierarchy.BoneCount];
        actor.GetPose(frame, source);
        Assert.True(_retargeter.TryRetarget(source, _pose));
        _pose.UpdateWorld();
        (Vector3, Vector3) free = (Place(HumanoidBone.LeftFoot), Place(HumanoidBone.RightFoot));
        _planter.Plant(_pose, actor.GetFootContacts(frame), frame / Rate);
        return free;
    }

    private float Ankle(HumanoidBone foot) => Place(foot).Y;

    private Vector3 Place(HumanoidBone foot) => _pose.WorldPositions[_rig.GetNode(foot)];
}
