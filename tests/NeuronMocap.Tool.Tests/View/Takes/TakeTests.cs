using System.Numerics;
using NeuronMocap.Bvh;
using NeuronMocap.Calculation;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;
using NeuronMocap.Tool.Tests.Convert;
using NeuronMocap.Tool.View.Takes;

namespace NeuronMocap.Tool.Tests.View.Takes;

public sealed class TakeTests
{
    private const float SameRotation = 0.05f; // cm at the end of a limb: a compact rotation is within 0.01 degrees

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public async Task Every_frame_of_a_bvh_take_has_the_joints_of_the_file(bool displacement)
    {
        using var takes = new OpenTakes();
        BvhDocument document = Files.Takes.Actor(100, displacement: displacement);
        document.Save(takes.Folder["walk.bvh"]);

        Take take = await takes.OpenAsync(takes.Folder["walk.bvh"]);

        Assert.Empty(take.Problems);
        TakePerformer performer = Assert.Single(take.Performers);
        Assert.Equal(100, performer.Frames);
        Assert.Equal(60, performer.Rate!.Value, 6);
        var source = new BvhSource(document);
        BoneTransform[] expected = new BoneTransform[BoneHierarchy.BoneCount];
        foreach (int frame in (int[])[99, 0, 41])
        {
            source.GetPose(frame, expected);
            AssertSame(expected, performer, frame);
            Assert.Equal(frame / 60.0, SecondsOf(performer, frame), 5);
        }
    }

    // A stream does not carry its rotation order.
    [Fact]
    public async Task A_stream_is_read_in_the_rotation_order_that_the_user_names()
    {
        using var takes = new OpenTakes();
        string path = takes.Record(Enumerable.Range(0, 60).Select(static i => (i * 20.0, 0, i)), order: RotationOrder.XYZ);

        Take take = await takes.OpenAsync(path, RotationOrder.XYZ);

        var expected = new BoneTransform[BoneHierarchy.BoneCount];
        OpenTakes.GetPose(0, 30, expected);
        AssertSame(expected, Assert.Single(take.Performers), 30);
    }

    [Fact]
    public async Task Performers_of_a_recording_have_their_own_bodies_and_times()
    {
        using var takes = new OpenTakes();
        string path = takes.Record(Enumerable.Range(0, 60).SelectMany(static i => new[] { (i * 20.0, 0, i), ((i * 20.0) + 5, 1, i) }));

        Take take = await takes.OpenAsync(path);

        Assert.Equal(2, take.Performers.Length);
        BoneTransform[] expected = new BoneTransform[BoneHierarchy.BoneCount];
        foreach (TakePerformer performer in take.Performers)
        {
            Assert.Equal($"Actor {performer.Source.Avatar}", performer.Name);
            Assert.Equal(60, performer.Frames);
            Assert.Equal(50, performer.Rate!.Value, 3);
            OpenTakes.GetPose(performer.Source.Avatar, 30, expected);
            AssertSame(expected, performer, 30);
            Assert.Equal(0.6 + (performer.Source.Avatar * 0.005), SecondsOf(performer, 30), 5);
        }
    }

    [Fact]
    public async Task A_pause_in_a_recording_is_a_gap()
    {
        using var takes = new OpenTakes();
        string path = takes.Record(Enumerable.Range(0, 60).Select(static i => (i * 20.0 + (i < 30 ? 0 : 4000), 0, i)));

        Take take = await takes.OpenAsync(path);

        TimeStretch gap = Assert.Single(take.Performers[0].Times.GetGaps());
        Assert.Equal(new TimeStretch(580_000, 4_600_000), gap);
        Assert.DoesNotContain(take.Performers[0].GetContacts().Left, step => step.From < 1_000_000 && step.To > 4_000_000);
    }

    [Fact]
    public async Task Frames_that_arrive_in_a_burst_have_the_times_at_which_they_were_sent()
    {
        using var takes = new OpenTakes();
        string path = takes.Record(Enumerable.Range(0, 600).Select(static i => (i is < 200 or > 300 ? i * 20.0 : 6005, 0, i)));

        Take take = await takes.OpenAsync(path);

        TakePerformer performer = take.Performers[0];
        Assert.Empty(performer.Times.GetGaps());
        Assert.Equal(600, performer.Frames);
        for (int frame = 0; frame < 600; frame++)
            Assert.Equal(frame * 0.02, SecondsOf(performer, frame), 0.006);
    }

    [Fact]
    public async Task Frames_that_come_twice_or_late_are_told_and_left_out()
    {
        using var takes = new OpenTakes();
        string path = takes.Record([(0, 0, 1), (20, 0, 2), (25, 0, 2), (40, 0, 4), (45, 0, 3), (60, 0, 5)]);

        Take take = await takes.OpenAsync(path);

        Assert.Equal(4, take.Performers[0].Frames);
        Assert.Contains(take.Problems, static problem => problem.Contains("2 frames", StringComparison.Ordinal));
    }

    [Fact]
    public async Task A_calculation_export_becomes_poses()
    {
        using var takes = new OpenTakes();
        Files.Takes.Actor(240).Save(takes.Folder["walk.bvh"]);
        await Conversion.ConvertAsync(takes.Folder["walk.bvh"], takes.Folder["walk.calc"]);

        Take take = await takes.OpenAsync(takes.Folder["walk.calc"]);

        TakePerformer performer = Assert.Single(take.Performers);
        Assert.Equal(240, performer.Frames);
        var source = new CalculationSource(CalculationDocument.Load(takes.Folder["walk.calc"]));
        BoneTransform[] expected = new BoneTransform[BoneHierarchy.BoneCount];
        source.GetPose(100, expected);
        ForwardKinematics.ToWorld(expected, expected, source.Variant);
        Vector3 head = new BoneChain(performer.Body, Bone.Head).Measure(PoseOf(performer, 100)).Place;
        Assert.True(Vector3.Distance(expected[(int)Bone.Head].Position, head) < SameRotation);
        Assert.NotEmpty(performer.GetContacts().Left);
    }

    [Fact]
    public async Task A_take_of_one_frame_and_an_empty_take_open()
    {
        using var takes = new OpenTakes();
        Files.Takes.Actor(1).Save(takes.Folder["one.bvh"]);
        Files.Takes.Actor(0).Save(takes.Folder["none.bvh"]);

        Take one = await takes.OpenAsync(takes.Folder["one.bvh"]);
        Take none = await takes.OpenAsync(takes.Folder["none.bvh"]);

        Assert.Equal(1, Assert.Single(one.Performers).Frames);
        Assert.Equal(TimeSpan.Zero, one.Duration);
        Assert.Equal(0, Assert.Single(none.Performers).Frames);
        Assert.Equal("The file holds a skeleton but no frames.", Assert.Single(none.Problems));
    }

    [Theory]
    [InlineData("picture.bvh", "not a picture", "'picture.bvh' is neither")]
    [InlineData("hand.bvh", Files.Takes.TwoJoints, "59 bones")]
    public void A_file_of_a_wrong_kind_is_one_sentence_with_its_name_or_reason(string name, string text, string words)
    {
        using var takes = new OpenTakes();
        string path = takes.Folder.Write("upload", text);
        NeuronException fault = Assert.Throws<NeuronException>(() => takes.Library.Open(path, name));
        Assert.Contains(words, fault.Message, StringComparison.Ordinal);
        Assert.DoesNotContain(path, fault.Message, StringComparison.Ordinal);
    }

    [Fact]
    public async Task Damage_in_a_recording_is_told()
    {
        using var takes = new OpenTakes();
        string path = takes.Record(Enumerable.Range(0, 300).Select(static i => (i * 20.0, 0, i)));
        byte[] bytes = await File.ReadAllBytesAsync(path);
        bytes.AsSpan(bytes.Length / 2, 64).Fill(0xEE);
        await File.WriteAllBytesAsync(path, bytes);

        Take take = await takes.OpenAsync(path);

        Assert.NotEmpty(take.Problems);
        Assert.InRange(take.Performers[0].Frames, 1, 299);
    }

    [Fact]
    public async Task Closing_the_library_deletes_temporary_files()
    {
        using var takes = new OpenTakes();
        Files.Takes.Actor(10).Save(takes.Folder["walk.bvh"]);
        Take take = await takes.OpenAsync(takes.Folder["walk.bvh"]);
        Assert.Equal(10, take.Performers[0].Frames);

        takes.Library.Dispose();

        Assert.Equal(0, takes.ScratchFiles);
        Assert.True(File.Exists(takes.Folder["walk.bvh"]));
        Assert.Throws<ObjectDisposedException>(() => PoseOf(take.Performers[0], 0));
    }

    private static byte[] PoseOf(TakePerformer performer, long frame)
    {
        byte[] pose = new byte[performer.Poses.RecordSize];
        Assert.Equal(1, performer.Poses.Read(frame, pose));
        return pose;
    }

    private static double SecondsOf(TakePerformer performer, long frame)
    {
        Assert.True(CompactPose.TryDecode(PoseOf(performer, frame), out CompactPoseHeader header, new BoneTransform[BoneHierarchy.BoneCount]));
        return (header.Time - DateTimeOffset.UnixEpoch).TotalSeconds;
    }

    private static void AssertSame(BoneTransform[] local, TakePerformer performer, long frame)
    {
        BoneTransform[] expected = new BoneTransform[BoneHierarchy.BoneCount];
        BoneTransform[] actual = new BoneTransform[BoneHierarchy.BoneCount];
        ForwardKinematics.ToWorld(local, expected, performer.Body.Variant);
        CompactPose.TryDecode(PoseOf(performer, frame), out _, actual, performer.Body);
        ForwardKinematics.ToWorld(actual, actual, performer.Body.Variant);
        for (int bone = 0; bone < expected.Length; bone++)
            Assert.True(Vector3.Distance(expected[bone].Position, actual[bone].Position) < SameRotation, $"{(Bone)bone} of frame {frame}");
    }
}
