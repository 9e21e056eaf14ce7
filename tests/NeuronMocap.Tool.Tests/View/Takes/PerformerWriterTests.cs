using NeuronMocap.Server;
using NeuronMocap.Skeleton;
using NeuronMocap.Tool.Tests.Files;
using NeuronMocap.Tool.View.Takes;

namespace NeuronMocap.Tool.Tests.View.Takes;

// What remains of a performer if one of its two files has no more room.
public sealed class PerformerWriterTests : IDisposable
{
    private const double Rate = 60;

    private readonly TemporaryFolder _folder = new();
    private readonly SyntheticSource _actor = new(Rate);
    private readonly BoneTransform[] _pose = new BoneTransform[BoneHierarchy.BoneCount];

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Without_room_for_poses_the_rest_is_kept()
    {
        PerformerWriter writer = Create(fullFile: 0);
        using TakePerformer performer = writer.Performer;

        Assert.Throws<IOException>(() => AddAll(writer));
        Assert.Throws<IOException>(writer.Finish);

        Assert.InRange(performer.Frames, 1, 1999);
        Assert.Equal(Rate, performer.Rate!.Value, 3);
        Assert.NotEmpty(performer.GetContacts().Left);
        Assert.NotEmpty(performer.GetContacts().Right);
        float[] summary = new float[TakePerformer.SummaryValues];
        Assert.Equal(1, performer.ReadSummaries(0, summary));
        AssertEndsAtLastFrame(performer);
    }

    [Fact]
    public void Without_room_for_summaries_the_times_end_with_the_frames()
    {
        PerformerWriter writer = Create(fullFile: 1);
        using TakePerformer performer = writer.Performer;
        for (int frame = 0; frame < 600; frame++)
            Add(writer, frame);

        Assert.Throws<IOException>(writer.Flush);
        long before = performer.Frames;
        Assert.Throws<IOException>(writer.Finish);

        Assert.Equal(before, performer.Frames);
        Assert.Equal(Rate, performer.Rate!.Value, 3);
        Assert.NotEmpty(performer.GetContacts().Left);
        AssertEndsAtLastFrame(performer);
    }

    // The summaries find out that they have no room while a frame is added, after its pose.
    [Fact]
    public void Poses_without_a_summary_can_be_read()
    {
        PerformerWriter writer = Create(fullFile: 1);
        using TakePerformer performer = writer.Performer;

        Assert.Throws<IOException>(() => AddAll(writer));
        Assert.Throws<IOException>(writer.Finish);

        AssertEndsAtLastFrame(performer);
    }

    private PerformerWriter Create(int fullFile)
    {
        Assert.SkipUnless(OperatingSystem.IsLinux(), "Other systems have no file that is always full.");
        int created = 0;
        return new PerformerWriter(
            size => created++ == fullFile ? new RecordFile(File.OpenHandle("/dev/full", access: FileAccess.ReadWrite), size) : new RecordFile(_folder["."], size),
            "0-0",
            0,
            new AvatarName("Actor"),
            default,
            SkeletonBody.GetDefault());
    }

    private void AddAll(PerformerWriter writer)
    {
        for (int frame = 0; frame < 2000; frame++)
            Add(writer, frame);
    }

    private void Add(PerformerWriter writer, int frame)
    {
        _actor.GetPose(frame, _pose);
        writer.Add(TimeSpan.FromSeconds(frame / Rate), (uint)frame, 0, _pose, measured: null);
    }

    private static void AssertEndsAtLastFrame(TakePerformer performer)
    {
        byte[] last = new byte[performer.Poses.RecordSize];
        Assert.Equal(1, performer.Poses.Read(performer.Frames - 1, last));
        Assert.True(CompactPose.TryDecode(last, out CompactPoseHeader header, new BoneTransform[BoneHierarchy.BoneCount]));
        Assert.Equal(performer.Times.End, (header.Time - DateTimeOffset.UnixEpoch).TotalMicroseconds);
    }
}
