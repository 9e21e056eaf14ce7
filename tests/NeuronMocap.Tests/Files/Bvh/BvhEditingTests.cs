using NeuronMocap.Bvh;
using NeuronMocap.Skeleton;
using static NeuronMocap.Tests.Bvh.BvhSamples;

namespace NeuronMocap.Tests.Bvh;

/// <summary>Trimming, joining and resampling: the effect on the frames of a take.</summary>
public class BvhEditingTests
{
    private static readonly BvhDocument Five = Numbered(5, new BvhFrameTime(1, 120));

    [Fact]
    public void A_part_of_a_take_keeps_rows_and_rate()
    {
        BvhDocument part = Five.Trim(1, 3);

        Assert.Equal(3, part.FrameCount);
        AssertBits(Five.GetValues(1), part.GetValues(0));
        AssertBits(Five.GetValues(3), part.GetValues(2));
        Assert.Equal(Five.FrameTime, part.FrameTime);
        Assert.Equal(0, Five.Trim(5, 0).FrameCount);
    }

    [Theory]
    [InlineData(-1, 1, "start")]
    [InlineData(6, 0, "start")]
    [InlineData(2, 4, "count")]
    [InlineData(2, -1, "count")]
    public void A_part_must_lie_within_the_take(int start, int count, string parameter) =>
        Assert.Throws<ArgumentOutOfRangeException>(parameter, () => Five.Trim(start, count));

    [Fact]
    public void A_part_by_time_snaps_to_the_nearest_frames()
    {
        BvhDocument take = Numbered(241, new BvhFrameTime(1, 120));
        BvhDocument part = take.Trim(TimeSpan.FromSeconds(0.5), TimeSpan.FromSeconds(1));

        Assert.Equal(120, part.FrameCount);
        AssertBits(take.GetValues(60), part.GetValues(0));
        AssertBits(take.GetValues(1), take.Trim(TimeSpan.FromTicks(83_333), TimeSpan.FromTicks(83_333)).GetValues(0));
        Assert.Equal(240, take.Trim(TimeSpan.Zero, TimeSpan.FromSeconds(2)).FrameCount);
        Assert.Throws<ArgumentOutOfRangeException>(() => take.Trim(TimeSpan.Zero, TimeSpan.FromSeconds(2.1)));
        Assert.Throws<ArgumentOutOfRangeException>(() => take.Trim(TimeSpan.FromSeconds(-1), TimeSpan.FromSeconds(1)));
    }

    [Fact]
    public void Joined_takes_follow_each_other()
    {
        BvhDocument joined = BvhEditing.Join([Five, Five.Trim(0, 0), Five.Trim(1, 2)]);

        Assert.Equal(7, joined.FrameCount);
        AssertBits([.. Values(Five), .. Values(Five.Trim(1, 2))], Values(joined));
    }

    [Theory]
    [InlineData("JOINT Spine", "JOINT Back", "joint 2 is Back instead of Spine")]
    [InlineData("OFFSET 0.5 14.307 1e-1", "OFFSET 0.5 15 1e-1", "the OFFSET of Spine")]
    [InlineData("CHANNELS 3 Yrotation Xrotation", "CHANNELS 3 Xrotation Yrotation", "Spine has the channels")]
    [InlineData("Frame Time: 0.008", "Frame Time: 0.010", "Resample")]
    public void Different_takes_are_not_joined(string text, string other, string reason)
    {
        BvhDocument next = Parse(TwoRows.Replace(text, other, StringComparison.Ordinal));
        NeuronException failure = Assert.Throws<NeuronException>(() => BvhEditing.Join([Parse(TwoRows), next]));
        Assert.Contains(reason, failure.Message, StringComparison.Ordinal);
    }

    // The root's position channels replace its OFFSET, so its OFFSET says nothing about the body.
    [Fact]
    public void The_offset_of_a_joint_with_positions_may_differ() =>
        Assert.Equal(4, BvhEditing.Join([Parse(TwoRows), Parse(TwoRows.Replace("93.020", "90", StringComparison.Ordinal))]).FrameCount);

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void An_aligned_take_continues_the_one_before(bool hasReference)
    {
        var random = new RandomTakes(7);
        BvhHierarchy hierarchy = BvhBoneHierarchy.Create(SkeletonFormat.Default, new ChannelLayout(hasDisplacement: false, hasReference));
        var first = new BvhDocument(hierarchy, BvhFrameTime.Default, random.Motion(hierarchy, 20));
        var second = new BvhDocument(hierarchy, BvhFrameTime.Default, random.Motion(hierarchy, 30));

        BvhDocument joined = BvhEditing.Join([first, second], align: true);

        // As a whole: all distances and heights stay.
        var before = new RawPose(joined, 19);
        var start = new RawPose(joined, 20);
        AssertNear([before.Position("Hips")[0], before.Position("Hips")[2]], [start.Position("Hips")[0], start.Position("Hips")[2]], 1e-3);
        for (int frame = 0; frame < 30; frame += 7)
        {
            var expected = new RawPose(second, frame);
            var actual = new RawPose(joined, 20 + frame);
            foreach (string joint in (string[])["Hips", "Head", "LeftHand"])
            {
                Assert.Equal(expected.Position(joint)[1], actual.Position(joint)[1], 1e-3);
                Assert.Equal(Horizontal(expected, joint, new RawPose(second, 0)), Horizontal(actual, joint, start), 1e-3);
            }
        }

        // No other heading brings the hips closer to their previous orientation.
        double nearest = before.Distance(start).Rotation;
        Assert.True(nearest <= 2, $"{nearest}");
        for (int frame = 1; frame < 50; frame++)
            Assert.True(LargestStep(joined, frame) < 180, $"The hips jump at frame {frame}.");
    }

    [Fact]
    public void Takes_of_equal_heading_are_aligned_by_translation()
    {
        var random = new RandomTakes(8);
        BvhHierarchy hierarchy = BvhBoneHierarchy.Create(default, default);
        var take = new BvhDocument(hierarchy, BvhFrameTime.Default, random.Motion(hierarchy, 2));
        BvhDocument last = take.Trim(1, 1);

        BvhDocument joined = BvhEditing.Join([take, last], align: true);
        AssertNear(Values(last).Select(value => (double)value), joined.GetValues(2).ToArray().Select(value => (double)value), 1e-4);
    }

    [Fact]
    public void NaN_rows_at_the_seam_do_not_affect_the_alignment()
    {
        var random = new RandomTakes(9);
        BvhHierarchy hierarchy = BvhBoneHierarchy.Create(default, default);
        float[] motion = random.Motion(hierarchy, 3);
        motion.AsSpan(2 * hierarchy.ChannelCount).Fill(float.NaN);
        var first = new BvhDocument(hierarchy, BvhFrameTime.Default, motion);
        motion = random.Motion(hierarchy, 3);
        motion.AsSpan(0, hierarchy.ChannelCount).Fill(float.NaN);
        var second = new BvhDocument(hierarchy, BvhFrameTime.Default, motion);

        BvhDocument joined = BvhEditing.Join([first, second], align: true);

        var before = new RawPose(joined, 1);
        var start = new RawPose(joined, 4);
        AssertNear([before.Position("Hips")[0], before.Position("Hips")[2]], [start.Position("Hips")[0], start.Position("Hips")[2]], 1e-3);
        Assert.All(joined.GetValues(5).ToArray(), static value => Assert.True(float.IsFinite(value)));
    }

    [Fact]
    public void A_resampled_rate_is_written_in_full()
    {
        var half = new BvhDocument(Five.Hierarchy, BvhFrameTime.FromFrameRate(60), Five.CopyValues()) { TextFormat = Five.TextFormat with { FrameTimeText = "0.008" } };

        BvhDocument take = half.Resample(120);

        Assert.Null(take.TextFormat.FrameTimeText);
        Assert.Equal(120, take.FrameTime.FrameRate);
    }

    [Fact]
    public void Resampling_120_to_60_Hz_takes_every_second_frame()
    {
        BvhDocument half = Five.Resample(60);

        Assert.Equal(new BvhFrameTime(1, 60), half.FrameTime);
        Assert.Equal(3, half.FrameCount);
        for (int frame = 0; frame < 3; frame++)
            AssertBits(Five.GetValues(2 * frame), half.GetValues(frame));
    }

    [Fact]
    public void Resampling_keeps_the_last_frame()
    {
        BvhDocument take = Five.Trim(0, 4).Resample(60);

        Assert.Equal(3, take.FrameCount);
        AssertBits(Five.GetValues(2), take.GetValues(1));
        AssertBits(Five.GetValues(3), take.GetValues(2));
    }

    // Seventeen minutes at 59.94 Hz. With the rate as a double, the last frames would not be exact.
    [Fact]
    public void Times_are_fractions()
    {
        BvhHierarchy hierarchy = Parse("HIERARCHY\nROOT A\n{\nOFFSET 0 0 0\nCHANNELS 1 Xposition\n}\n").Hierarchy;
        float[] values = [.. Enumerable.Range(0, 60_001).Select(static frame => (float)frame)];
        BvhDocument resampled = new BvhDocument(hierarchy, new BvhFrameTime(1001, 60_000), values).Resample(new BvhFrameTime(1, 1000));

        Assert.Equal(1_001_001, resampled.FrameCount);
        for (int frame = 0; frame <= 1_001_000; frame += 1001)
            Assert.Equal(frame / 1001f * 60, resampled.GetValues(frame)[0]);
    }

    [Fact]
    public void Rotations_are_interpolated_on_the_shortest_path()
    {
        for (int seed = 0; seed < 40; seed++)
        {
            BvhDocument take = new RandomTakes(seed).Take(new RandomTakes(seed).TurningHierarchy(), 4);
            BvhDocument twice = take.Resample(new BvhFrameTime(take.FrameTime.Numerator, take.FrameTime.Denominator * 2));

            Assert.Equal(7, twice.FrameCount);
            for (int frame = 1; frame < 7; frame += 2)
            {
                foreach (BvhJoint joint in take.Joints)
                    AssertHalfWay(joint, take.GetValues(frame / 2), twice.GetValues(frame), take.GetValues((frame / 2) + 1));
            }
        }
    }

    // (179, 10, -3) and (-1, 170, 177) are the same rotation. Interpolating the angles gives neither, but interpolating the rotation does.
    [Fact]
    public void An_angle_flip_is_no_motion()
    {
        BvhHierarchy hierarchy = Parse("HIERARCHY\nROOT A\n{\nOFFSET 0 0 0\nCHANNELS 3 Yrotation Xrotation Zrotation\n}\n").Hierarchy;
        var take = new BvhDocument(hierarchy, BvhFrameTime.Default, [179, 10, -3, -1, 170, 177]);

        BvhDocument resampled = take.Resample(480);
        Assert.Equal(5, resampled.FrameCount);
        for (int frame = 0; frame < 5; frame++)
            Assert.Equal(0, new RawPose(resampled, frame).Distance(new RawPose(take, 0)).Rotation, 1e-6);
    }

    private static BvhDocument Numbered(int frames, BvhFrameTime time)
    {
        BvhHierarchy hierarchy = Parse(Hierarchy).Hierarchy;
        return new BvhDocument(hierarchy, time, [.. Enumerable.Range(0, frames * 9).Select(static i => (i / 3f) + 0.1f)]);
    }

    private static void AssertHalfWay(BvhJoint joint, ReadOnlySpan<float> from, ReadOnlySpan<float> middle, ReadOnlySpan<float> to)
    {
        int first = joint.FirstChannel + joint.Channels.Count - 3;
        RotationOrder order = Enum.Parse<RotationOrder>(string.Concat(joint.Channels.TakeLast(3).Select(static channel => channel.ToString()[0])));
        var a = EulerAngles.ToQuaternion(new(from[first], from[first + 1], from[first + 2]), order);
        var b = EulerAngles.ToQuaternion(new(to[first], to[first + 1], to[first + 2]), order);
        var half = EulerAngles.ToQuaternion(new(middle[first], middle[first + 1], middle[first + 2]), order);
        var expected = System.Numerics.Quaternion.Slerp(a, b, 0.5f);
        Assert.Equal(1, Math.Abs(System.Numerics.Quaternion.Dot(expected, half)), 1e-5);
    }

    private static double Horizontal(RawPose pose, string joint, RawPose origin)
    {
        double x = pose.Position(joint)[0] - origin.Position("Hips")[0];
        double z = pose.Position(joint)[2] - origin.Position("Hips")[2];
        return Math.Sqrt((x * x) + (z * z));
    }

    private static float LargestStep(BvhDocument take, int frame) =>
        Enumerable.Range(3, 3).Max(column => Math.Abs(take.GetValues(frame)[column] - take.GetValues(frame - 1)[column]));

    private static void AssertNear(IEnumerable<double> expected, IEnumerable<double> actual, double tolerance) =>
        Assert.All(expected.Zip(actual), pair => Assert.Equal(pair.First, pair.Second, tolerance));
}
