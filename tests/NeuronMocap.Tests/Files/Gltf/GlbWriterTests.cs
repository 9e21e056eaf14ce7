using System.Numerics;
using NeuronMocap.Gltf;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Gltf;

public sealed class GlbWriterTests
{
    // In millimetres.
    private const float SamePlace = 0.02f;

    [Fact]
    public void Joints_are_where_forward_kinematics_puts_them()
    {
        GlbFile file = GlbTake.Write(null, static writer => GlbTake.WriteFrames(writer.AddAvatar("Anna", GlbTake.Body), 120));

        foreach (int frame in (int[])[0, 1, 37, 119])
            Assert.InRange(GlbTake.Distance(GlbTake.Joints(GlbTake.Pose(frame)), file.Joints(GlbTake.Time(frame).TotalSeconds)), 0, SamePlace);
    }

    [Fact]
    public void Each_frame_has_a_key_and_bones_that_never_turn_have_one()
    {
        GlbFile file = GlbTake.Write(null, static writer =>
        {
            GlbAvatar avatar = writer.AddAvatar("Anna", GlbTake.Body);
            for (int frame = 0; frame < 120; frame++)
                avatar.WriteFrame(GlbTake.Time(frame), Stiff(frame));
        });

        Assert.Equal(120, file.KeyTimes(0, "Hips").Length);
        Assert.Equal(120, file.KeyTimes(0, "Hips", "translation").Length);
        Assert.Single(file.KeyTimes(0, "LeftHandIndex3"));
        Assert.Empty(file.KeyTimes(0, "Head", "translation"));
        Assert.Equal(120, file.KeyTimes(0, "LeftHandIndex2").Length);
        Assert.Equal(GlbTake.Time(119).TotalSeconds, file.KeyTimes(0, "Hips")[^1], 1e-6);
        Assert.InRange(GlbTake.Distance(GlbTake.Joints(Stiff(119)), file.Joints(GlbTake.Time(119).TotalSeconds)), 0, SamePlace);

        // A finger without a sensor, and one that begins to move late.
        static BoneTransform[] Stiff(int frame)
        {
            BoneTransform[] pose = GlbTake.Pose(frame);
            pose[(int)Bone.LeftHandIndex3] = pose[(int)Bone.LeftHandIndex3] with { Rotation = Quaternion.CreateFromYawPitchRoll(0.1f, 0.2f, 0.3f) };
            if (frame < 119)
                pose[(int)Bone.LeftHandIndex2] = pose[(int)Bone.LeftHandIndex2] with { Rotation = Quaternion.Identity };

            return pose;
        }
    }

    [Fact]
    public void Positions_of_bones_that_move_have_keys()
    {
        GlbFile file = GlbTake.Write(null, static writer =>
        {
            GlbAvatar avatar = writer.AddAvatar("Anna", GlbTake.Body);
            for (int frame = 0; frame < 60; frame++)
                avatar.WriteFrame(GlbTake.Time(frame), Stretched(frame));
        });

        Assert.InRange(file.KeyTimes(0, "LeftHand", "translation").Length, 3, 60);
        foreach (int frame in (int[])[0, 29, 30, 31, 59])
            Assert.InRange(GlbTake.Distance(GlbTake.Joints(Stretched(frame)), file.Joints(GlbTake.Time(frame).TotalSeconds)), 0, SamePlace);

        static BoneTransform[] Stretched(int frame)
        {
            BoneTransform[] pose = GlbTake.Pose(frame);
            if (frame >= 30)
                pose[(int)Bone.LeftHand] = pose[(int)Bone.LeftHand] with { Position = pose[(int)Bone.LeftHand].Position + new Vector3(5, 0, 0) };

            return pose;
        }
    }

    [Theory, InlineData(30), InlineData(24), InlineData(100)]
    public void Another_rate_has_even_keys_of_interpolated_poses(double rate)
    {
        GlbFile file = GlbTake.Write(new GlbOptions { FrameRate = rate }, static writer => GlbTake.WriteFrames(writer.AddAvatar("Anna", GlbTake.Body), 121));

        float[] times = file.KeyTimes(0, "Hips");
        Assert.Equal((2 * rate) + 1, times.Length);
        for (int key = 0; key < times.Length; key++)
            Assert.Equal(key / rate, times[key], 1e-6);

        Assert.InRange(GlbTake.Distance(GlbTake.Joints(GlbTake.Pose(120)), file.Joints(2)), 0, SamePlace);
        Assert.InRange(GlbTake.Distance(GlbTake.Joints(GlbTake.Pose(60)), file.Joints(1)), 0, SamePlace);
        Assert.InRange(GlbTake.Distance(GlbTake.Joints(GlbTake.Pose(31)), file.Joints(31 / GlbTake.Rate)), 0, 10);
    }

    [Fact]
    public void Fewer_keys_keep_every_frame_within_the_tolerance()
    {
        var options = new GlbOptions { RotationTolerance = 0.5f, PositionTolerance = 1 };
        byte[] all = GlbTake.WriteBytes(null, Write), few = GlbTake.WriteBytes(options, Write);
        GlbFile exact = GlbFile.Parse(all), file = GlbFile.Parse(few);

        int figure = GlbWriter.CreateFigure(GlbTake.Body).Length;
        Assert.True(few.Length - figure < (all.Length - figure) / 3, $"{few.Length} of {all.Length} bytes, {figure} of them the figure.");
        Assert.Equal([0, (float)GlbTake.Time(299).TotalSeconds], [file.KeyTimes(0, "Hips")[0], file.KeyTimes(0, "Hips")[^1]]);
        for (int frame = 0; frame < 300; frame += 7)
        {
            double time = GlbTake.Time(frame).TotalSeconds;
            Vector3[] right = exact.Joints(time), reduced = file.Joints(time);
            Assert.InRange(Vector3.Distance(right[0], reduced[0]) * 1000, 0, 1.01f);
            Assert.InRange(GlbTake.Distance(right, reduced), 0, 30);
        }

        static void Write(GlbWriter writer) => GlbTake.WriteFrames(writer.AddAvatar("Anna", GlbTake.Body), 300);
    }

    [Fact]
    public void Each_avatar_has_a_skin_and_an_animation()
    {
        GlbFile file = GlbTake.Write(null, static writer =>
        {
            GlbAvatar anna = writer.AddAvatar("Anna", GlbTake.Body), ben = writer.AddAvatar("Ben", SkeletonBody.GetDefault(SkeletonVariant.Spine3));
            writer.AddAvatar("Carl", GlbTake.Body);
            for (int frame = 0; frame < 10; frame++)
            {
                anna.WriteFrame(GlbTake.Time(frame), GlbTake.Pose(frame));
                ben.WriteFrame(GlbTake.Time(frame + 5), GlbTake.Pose(frame + 100));
            }
        });

        Assert.Equal(["Anna", "Ben"], file.Names("animations"));
        Assert.Equal(["Anna skin", "Ben skin", "Carl skin"], file.Names("skins"));
        Assert.Equal(["Figure body", "Anna joints", "Ben joints", "Carl joints"], file.Names("materials"));
        Assert.InRange(GlbTake.Distance(GlbTake.Joints(GlbTake.Pose(9)), file.Joints(GlbTake.Time(9).TotalSeconds)), 0, SamePlace);
        Assert.Equal((float)GlbTake.Time(5).TotalSeconds, file.KeyTimes(1, "Hips", skin: 1)[0]);
        Assert.Equal(59, file.Joints(0, skin: 2, animation: null).Length);
    }

    [Fact]
    public void A_figure_alone_stands_at_rest()
    {
        GlbFile file = GlbFile.Parse(GlbWriter.CreateFigure(GlbTake.Body, "Anna", 0x123456));
        var rest = new BoneTransform[BoneHierarchy.BoneCount];
        GlbTake.Body.CopyRestPose(rest);

        Assert.Empty(file.Animations);
        Assert.InRange(GlbTake.Distance(GlbTake.Joints(rest), file.Joints(0, animation: null)), 0, SamePlace);
        Assert.Equal(["Anna", .. BoneHierarchy.Bones.ToArray().Select(static bone => BoneHierarchy.GetName(bone)), "Anna figure"], file.Names("nodes"));
    }

    [Fact]
    public void Large_animations_go_through_a_temporary_file_and_are_the_same()
    {
        byte[] expected = GlbTake.WriteBytes(null, static writer => GlbTake.WriteFrames(writer.AddAvatar("Anna", GlbTake.Body), 300));
        using var stream = new MemoryStream();
        var spool = new KeySpool(memory: 1000);
        using (var writer = new GlbWriter(stream, null, leaveOpen: true, spool))
        {
            GlbTake.WriteFrames(writer.AddAvatar("Anna", GlbTake.Body), 300);
            GlbTake.WriteFrames(writer.AddAvatar("Ben", GlbTake.Body), 300);
            Assert.True(spool.IsFile);
        }

        GlbFile file = GlbFile.Parse(stream.ToArray()), same = GlbFile.Parse(expected);
        Assert.Equal(same.KeyTimes(0, "Hips"), file.KeyTimes(0, "Hips"));
        Assert.Equal(same.Joints(4.2), file.Joints(4.2));
    }

    [Fact]
    public void What_does_not_fit_is_refused_and_the_rest_is_written()
    {
        using var stream = new MemoryStream();
        using (var writer = new GlbWriter(stream, null, leaveOpen: true, new KeySpool(limit: 1_200_000)))
        {
            GlbAvatar avatar = writer.AddAvatar("Anna", GlbTake.Body);
            var exception = Assert.Throws<NeuronException>(() => GlbTake.WriteFrames(avatar, 10_000));
            Assert.Contains("4 GiB", exception.Message, StringComparison.Ordinal);
            Assert.InRange(avatar.FrameCount, 100, 1000);
        }

        GlbFile file = GlbFile.Parse(stream.ToArray());
        Assert.InRange(GlbTake.Distance(GlbTake.Joints(GlbTake.Pose(50)), file.Joints(GlbTake.Time(50).TotalSeconds)), 0, SamePlace);
    }

    [Fact]
    public void Wrong_arguments_are_refused()
    {
        using var stream = new MemoryStream();
        var writer = new GlbWriter(stream);
        GlbAvatar avatar = writer.AddAvatar("Anna", GlbTake.Body);
        Assert.Throws<ArgumentOutOfRangeException>(() => avatar.WriteFrame(TimeSpan.FromTicks(-1), GlbTake.Pose(0)));
        Assert.Throws<ArgumentException>(() => avatar.WriteFrame(TimeSpan.Zero, new BoneTransform[58]));
        Assert.Throws<ArgumentOutOfRangeException>(static () => new GlbOptions { FrameRate = 0 });
        Assert.Throws<ArgumentOutOfRangeException>(static () => new GlbOptions { FrameRate = double.NaN });
        Assert.Throws<ArgumentOutOfRangeException>(static () => new GlbOptions { RotationTolerance = 46 });
        Assert.Throws<ArgumentOutOfRangeException>(static () => new GlbOptions { PositionTolerance = float.NaN });

        writer.Dispose();
        writer.Dispose();
        Assert.Throws<ObjectDisposedException>(() => avatar.WriteFrame(TimeSpan.Zero, GlbTake.Pose(0)));
        Assert.Throws<ObjectDisposedException>(() => writer.AddAvatar("Ben", GlbTake.Body));
    }
}
