using System.Numerics;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Server.Sources;

namespace NeuronMocap.Server.Tests.Sources;

public class SyntheticSourceTests
{
    private const int LapFrames = 60 * ActorMeasures.LapSeconds;

    public static TheoryData<RotationOrder, bool, bool> Formats
    {
        get
        {
            var data = new TheoryData<RotationOrder, bool, bool>();
            foreach (RotationOrder order in Enum.GetValues<RotationOrder>())
            {
                for (int layout = 0; layout < 4; layout++)
                    data.Add(order, (layout & 1) != 0, (layout & 2) != 0);
            }

            return data;
        }
    }

    [Fact]
    public void An_actor_is_endless_with_displacement_and_the_given_rate()
    {
        var actor = new SyntheticSource(96);

        Assert.Null(actor.FrameCount);
        Assert.True(actor.HasDisplacement);
        Assert.Equal(96, actor.FrameRate);
        Assert.Equal(SkeletonVariant.Neck1, actor.Variant);
    }

    [Fact]
    public void Frames_are_deterministic_and_repeat_every_lap()
    {
        var actor = new SyntheticSource();
        foreach (long frame in (long[])[0, 1, 333, 1999, 2399])
        {
            BoneTransform[] pose = ActorMeasures.GetPose(actor, frame);
            Assert.Equal(pose, ActorMeasures.GetPose(actor, frame));
            Assert.Equal(pose, ActorMeasures.GetPose(new SyntheticSource(), frame));
            Assert.Equal(pose, ActorMeasures.GetPose(actor, frame + (LapFrames * 1_000_000_000L)));
            Assert.Equal(actor.GetFootContacts(frame), actor.GetFootContacts(frame + (LapFrames * 1_000_000_000L)));
        }
    }

    [Fact]
    public void The_speed_of_the_actor_does_not_depend_on_the_frame_rate()
    {
        for (long frame = 0; frame < LapFrames; frame += 41)
            Assert.Equal(ActorMeasures.GetPose(new SyntheticSource(60), frame), ActorMeasures.GetPose(new SyntheticSource(120), frame * 2));
    }

    [Theory]
    [InlineData(0, 0)]
    [InlineData(1, 0)]
    [InlineData(2, 0)]
    [InlineData(3, 0)]
    [InlineData(0, 1_000_000_000)]
    public void Joints_turn_slower_than_600_degrees_per_second_without_jumps(int avatar, long start)
    {
        var actor = new SyntheticSource(60, avatar);
        BoneTransform[] previous = ActorMeasures.GetPose(actor, start);
        for (long frame = start + 1; frame <= start + LapFrames; frame++)
        {
            BoneTransform[] pose = ActorMeasures.GetPose(actor, frame);
            foreach (Bone bone in BoneHierarchy.Bones)
            {
                double degrees = ActorMeasures.Degrees(previous[(int)bone].Rotation, pose[(int)bone].Rotation);
                Assert.True(degrees < 10, $"frame {frame}, {bone}: {degrees}");
            }

            Assert.True((pose[0].Position - previous[0].Position).Length() < 2.5f, $"frame {frame}");
            previous = pose;
        }
    }

    [Fact]
    public void Every_bone_moves_within_anatomical_limits()
    {
        var actor = new SyntheticSource();
        double[] least = [.. Enumerable.Repeat(360.0, BoneHierarchy.BoneCount)];
        double[] most = new double[BoneHierarchy.BoneCount];
        for (long frame = 0; frame < LapFrames; frame += 3)
        {
            BoneTransform[] pose = ActorMeasures.GetPose(actor, frame);
            for (int bone = 0; bone < pose.Length; bone++)
            {
                double degrees = ActorMeasures.Degrees(pose[bone].Rotation);
                least[bone] = Math.Min(least[bone], degrees);
                most[bone] = Math.Max(most[bone], degrees);
            }
        }

        foreach (Bone bone in BoneHierarchy.Bones)
        {
            Assert.True(most[(int)bone] - least[(int)bone] > 0.5, $"{bone} does not move");
            if (bone != Bone.Hips)
                Assert.True(most[(int)bone] <= GreatestAngle(bone), $"{bone}: {most[(int)bone]}");
        }
    }

    [Fact]
    public void Every_frame_has_the_default_body()
    {
        var actor = new SyntheticSource(60, 1);
        for (long frame = 0; frame < LapFrames; frame += 7)
        {
            BoneTransform[] pose = ActorMeasures.GetPose(actor, frame);
            foreach (Bone bone in BoneHierarchy.Bones)
            {
                Assert.Equal(1, pose[(int)bone].Rotation.Length(), 5);
                if (bone != Bone.Hips)
                    Assert.Equal(DefaultOffsets.Get(bone), pose[(int)bone].Position);
            }
        }
    }

    [Fact]
    public void The_head_stays_level_and_faces_ahead_while_walking()
    {
        var actor = new SyntheticSource();
        for (long frame = 0; frame < LapFrames; frame++)
        {
            BoneTransform[] world = ActorMeasures.GetWorld(actor, frame);
            Assert.True(Vector3.Transform(Vector3.UnitY, world[(int)Bone.Head].Rotation).Y > 0.85f, $"frame {frame}");
            Assert.True(Vector3.Transform(Vector3.UnitX, world[(int)Bone.Head].Rotation).Y is > -0.12f and < 0.12f, $"frame {frame}");
        }
    }

    [Fact]
    public void Avatars_differ_and_keep_apart()
    {
        SyntheticSource[] actors = [.. Enumerable.Range(0, 5).Select(avatar => new SyntheticSource(15, avatar))];
        for (long frame = 0; frame < 15 * ActorMeasures.LapSeconds; frame++)
        {
            BoneTransform[][] worlds = [.. actors.Select(actor => ActorMeasures.GetWorld(actor, frame))];
            for (int i = 1; i < worlds.Length; i++)
            {
                float distance = worlds[i].Min(bone => worlds[i - 1].Min(other => (bone.Position - other.Position).Length()));
                Assert.True(distance > 30, $"frame {frame}, avatars {i - 1} and {i}: {distance}");
                Assert.NotEqual(worlds[i][(int)Bone.Hips].Rotation, worlds[i - 1][(int)Bone.Hips].Rotation);
            }
        }
    }

    [Theory]
    [MemberData(nameof(Formats))]
    public void Values_in_every_layout_and_order_reproduce_the_pose(RotationOrder order, bool hasDisplacement, bool hasReference)
    {
        var actor = new SyntheticSource();
        var layout = new ChannelLayout(hasDisplacement, hasReference);
        float[] values = new float[layout.ValueCount];
        var header = new MotionHeader { HasDisplacement = hasDisplacement, HasReference = hasReference };
        for (long frame = 0; frame < LapFrames; frame += 17)
        {
            values.AsSpan().Fill(float.NaN);
            actor.WriteValues(frame, layout, order, values);
            var decoded = new MotionFrame(header, values, new SkeletonFormat(order, SkeletonVariant.Neck1));

            BoneTransform[] pose = ActorMeasures.GetPose(actor, frame);
            Assert.Equal(BoneTransform.Identity, decoded.GetReference());
            foreach (Bone bone in BoneHierarchy.Bones)
            {
                double degrees = ActorMeasures.Degrees(pose[(int)bone].Rotation, decoded.GetRotation(bone));
                Assert.True(degrees < 1e-3, $"frame {frame}, {bone}: {degrees}");
                Assert.Equal(pose[(int)bone].Position, decoded.GetPosition(bone));
            }
        }
    }

    [Fact]
    public void A_frame_allocates_nothing()
    {
        var actor = new SyntheticSource();
        var pose = new BoneTransform[BoneHierarchy.BoneCount];
        var layout = new ChannelLayout(hasDisplacement: true, hasReference: false);
        float[] values = new float[layout.ValueCount];
        void PlayLap()
        {
            for (long frame = 0; frame < LapFrames; frame += 29)
            {
                actor.GetPose(frame, pose);
                actor.WriteValues(frame, layout, RotationOrder.YXZ, values);
                actor.GetFootContacts(frame);
            }
        }

        PlayLap();
        Assert.Equal(0, Allocations.Least(() => Allocations.OnThisThread(PlayLap)));
    }

    [Fact]
    public void Invalid_rates_avatars_and_frames_are_refused()
    {
        Assert.Throws<ArgumentOutOfRangeException>(() => new SyntheticSource(0));
        Assert.Throws<ArgumentOutOfRangeException>(() => new SyntheticSource(double.NaN));
        Assert.Throws<ArgumentOutOfRangeException>(() => new SyntheticSource(double.PositiveInfinity));
        Assert.Throws<ArgumentOutOfRangeException>(() => new SyntheticSource(60, -1));
        Assert.Throws<ArgumentOutOfRangeException>(() => ActorMeasures.GetPose(new SyntheticSource(), -1));
        Assert.Throws<ArgumentOutOfRangeException>(() => new SyntheticSource().GetFootContacts(-1));
        Assert.Throws<ArgumentException>(() => new SyntheticSource().GetPose(0, new BoneTransform[58]));
    }

    private static double GreatestAngle(Bone bone) => bone switch
    {
        Bone.RightUpLeg or Bone.LeftUpLeg => 60,
        Bone.RightLeg or Bone.LeftLeg => 75,
        Bone.RightFoot or Bone.LeftFoot => 45,
        >= Bone.Spine and <= Bone.Spine2 => 15,
        >= Bone.Neck and <= Bone.Head => 35,
        Bone.RightShoulder or Bone.LeftShoulder => 20,
        Bone.RightArm or Bone.LeftArm => 100,
        Bone.RightForeArm or Bone.LeftForeArm => 125,
        Bone.RightHand or Bone.LeftHand => 30,
        _ => 100,
    };
}
