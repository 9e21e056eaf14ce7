using System.Numerics;
using NeuronMocap.Gltf;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Gltf;

public sealed class GlbHostileTests
{
    [Fact]
    public void No_avatar_gives_an_empty_scene() => Assert.Empty(GlbTake.Write(null, static _ => { }).Nodes);

    [Fact]
    public void One_frame_gives_one_key()
    {
        GlbFile file = GlbTake.Write(null, static writer => GlbTake.WriteFrames(writer.AddAvatar("Anna", GlbTake.Body), 1));

        Assert.Equal([0], file.KeyTimes(0, "Hips"));
        Assert.InRange(GlbTake.Distance(GlbTake.Joints(GlbTake.Pose(0)), file.Joints(0)), 0, 0.02f);
    }

    [Fact]
    public void Values_that_are_not_numbers_leave_the_bone_as_it_was()
    {
        GlbFile file = GlbTake.Write(null, static writer =>
        {
            GlbAvatar avatar = writer.AddAvatar("Anna", GlbTake.Body);
            for (int frame = 0; frame < 4; frame++)
            {
                BoneTransform[] pose = GlbTake.Pose(frame);
                if (frame == 2)
                    Break(pose);

                avatar.WriteFrame(GlbTake.Time(frame), pose);
            }

            Assert.Equal((4, 0, 1), (avatar.FrameCount, avatar.SkippedFrames, avatar.RepairedFrames));
        });

        BoneTransform[] expected = GlbTake.Pose(2), before = GlbTake.Pose(1);
        foreach (Bone bone in (Bone[])[Bone.Hips, Bone.LeftArm, Bone.RightArm])
            expected[(int)bone] = before[(int)bone];

        Assert.InRange(GlbTake.Distance(GlbTake.Joints(expected), file.Joints(GlbTake.Time(2).TotalSeconds)), 0, 0.02f);

        static void Break(BoneTransform[] pose)
        {
            pose[(int)Bone.Hips] = new BoneTransform(new Vector3(1, float.NaN, 2), new Quaternion(float.PositiveInfinity, 0, 0, 1));
            pose[(int)Bone.LeftArm] = pose[(int)Bone.LeftArm] with { Rotation = default };
            pose[(int)Bone.RightArm] = new BoneTransform(new Vector3(1e30f, 0, 0), new Quaternion(float.NaN, 0, 0, 1));
        }
    }

    [Fact]
    public void A_body_that_is_not_finite_gets_default_sizes()
    {
        Vector3[] offsets = SkeletonBody.GetDefault().Offsets.ToArray();
        offsets[(int)Bone.Head] = new Vector3(float.NaN, 0, 0);
        offsets[(int)Bone.Neck] = new Vector3(0, float.PositiveInfinity, 0);

        byte[] bytes = GlbWriter.CreateFigure(new SkeletonBody(offsets));

        Assert.Equal(GlbWriter.CreateFigure(SkeletonBody.GetDefault()), bytes);
    }

    [Fact]
    public void Names_are_kept_and_made_unique()
    {
        string[] names = ["a/b\\c\"", "😀 \u0001\n", "Anna", "Anna", "Anna (2)", "", " ", "Hips", "Spine3", "\ud83d"];
        GlbFile file = GlbTake.Write(null, writer =>
        {
            foreach (string name in names)
                GlbTake.WriteFrames(writer.AddAvatar(name, GlbTake.Body), 1);
        });

        Assert.Equal(
            ["a/b\\c\"", "😀 \u0001\n", "Anna", "Anna (2)", "Anna (2) (2)", "Avatar", "Avatar (2)", "Hips (figure)", "Spine3 (figure)", "\ufffd"],
            file.Names("animations"));
    }

    [Theory, InlineData(0.00999), InlineData(100_001), InlineData(1e50), InlineData(double.PositiveInfinity), InlineData(-1)]
    public void A_rate_outside_the_range_is_refused(double rate) =>
        Assert.Throws<ArgumentOutOfRangeException>(() => new GlbOptions { FrameRate = rate });

    [Theory, InlineData(0.01, 1), InlineData(100_000, 5001)]
    public void The_range_of_rates_includes_its_ends(double rate, int keys)
    {
        GlbFile file = GlbTake.Write(new GlbOptions { FrameRate = rate }, static writer => GlbTake.WriteFrames(writer.AddAvatar("Anna", GlbTake.Body), 4));
        Assert.Equal(keys, file.KeyTimes(0, "Hips").Length);
    }

    [Theory, InlineData(null), InlineData(30.0)]
    public void In_a_gap_of_an_hour_the_figure_keeps_its_pose(double? rate)
    {
        var hour = TimeSpan.FromHours(1);
        GlbFile file = GlbTake.Write(new GlbOptions { FrameRate = rate }, writer =>
        {
            GlbAvatar avatar = writer.AddAvatar("Anna", GlbTake.Body);
            GlbTake.WriteFrames(avatar, 31);
            for (int frame = 31; frame < 61; frame++)
                avatar.WriteFrame(hour + GlbTake.Time(frame), GlbTake.Pose(frame + 60));
        });

        float[] times = file.KeyTimes(0, "Hips");
        Assert.InRange(times.Length, 20, 70);
        double end = GlbTake.Time(30).TotalSeconds, start = (hour + GlbTake.Time(31)).TotalSeconds;
        foreach (double time in (double[])[end + 0.1, 1800, start - 0.1])
            Assert.InRange(GlbTake.Distance(GlbTake.Joints(GlbTake.Pose(30)), file.Joints(time)), 0, 0.02f);

        // Half an interval of the coarser rate later, and 0.24 ms of rounding.
        Assert.InRange(GlbTake.Distance(GlbTake.Joints(GlbTake.Pose(93)), file.Joints(start + GlbTake.Time(2).TotalSeconds)), 0, rate is null ? 0.5f : 20);
        Assert.Equal((hour + GlbTake.Time(60)).TotalSeconds, times[^1], 0.05);
    }

    [Fact]
    public void Of_frames_with_the_same_time_the_first_counts()
    {
        GlbFile file = GlbTake.Write(null, static writer =>
        {
            GlbAvatar avatar = writer.AddAvatar("Anna", GlbTake.Body);
            GlbTake.WriteFrames(avatar, 5);
            avatar.WriteFrame(GlbTake.Time(4), GlbTake.Pose(77));
            avatar.WriteFrame(GlbTake.Time(2), GlbTake.Pose(78));
            GlbTake.WriteFrames(avatar, 1, first: 5);
            Assert.Equal((6, 2), (avatar.FrameCount, avatar.SkippedFrames));
        });

        Assert.Equal(Enumerable.Range(0, 6).Select(static frame => (float)GlbTake.Time(frame).TotalSeconds), file.KeyTimes(0, "Hips"));
        Assert.InRange(GlbTake.Distance(GlbTake.Joints(GlbTake.Pose(4)), file.Joints(GlbTake.Time(4).TotalSeconds)), 0, 0.02f);
    }

    [Fact]
    public void After_many_hours_times_still_ascend()
    {
        var late = TimeSpan.FromHours(40);
        GlbFile file = GlbTake.Write(null, writer =>
        {
            GlbAvatar avatar = writer.AddAvatar("Anna", GlbTake.Body);
            for (int frame = 0; frame < 100; frame++)
                avatar.WriteFrame(late + (GlbTake.Time(frame) / 4), GlbTake.Pose(frame));

            Assert.Equal(100, avatar.FrameCount + avatar.SkippedFrames);
            Assert.InRange(avatar.SkippedFrames, 50, 90);
        });

        float[] times = file.KeyTimes(0, "Hips");
        Assert.Equal(times.Distinct().Order(), times);
    }
}
