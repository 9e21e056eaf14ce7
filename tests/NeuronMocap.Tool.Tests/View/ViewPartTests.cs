using System.Net;
using System.Numerics;
using NeuronMocap.Skeleton;
using NeuronMocap.Tool.Tests.Infrastructure;
using NeuronMocap.Tool.View.Access;
using NeuronMocap.Tool.View.Live;
using NeuronMocap.Tool.View.Performers;
using NeuronMocap.Tool.View.Web;

namespace NeuronMocap.Tool.Tests.View;

// Parts of the server that need no network.
public sealed class ViewPartTests
{
    [Theory]
    [InlineData("0-0", true)]
    [InlineData("12-4294967295", true)]
    [InlineData("0", false)]
    [InlineData("0-", false)]
    [InlineData("0-0-0", false)]
    [InlineData("-1-0", false)]
    [InlineData("0-4294967296", false)]
    [InlineData(" 0-0", false)]
    [InlineData(null, false)]
    public void The_text_of_a_key_identifies_a_performer(string? text, bool isKey)
    {
        Assert.Equal(isKey, PerformerKey.TryParse(text, out PerformerKey key));
        if (isKey)
            Assert.Equal(text, key.ToString());
    }

    [Fact]
    public void Every_performer_has_a_number_of_its_own()
    {
        var numbers = new PerformerNumbers();
        PerformerKey[] keys = [new(0, 0), new(1, 0), new(1, 1), new(0, 1000), new(2, 0), new(0, -1)];
        int?[] first = [.. keys.Select(numbers.Find)];
        Assert.Equal([0, 1000, 1, 1001, 1002, -1], first);
        Assert.Equal(first, keys.Select(numbers.Find));
    }

    [Fact]
    public void Invented_performers_are_bounded()
    {
        var numbers = new PerformerNumbers();
        int?[] found = [.. Enumerable.Range(0, 2000).Select(avatar => numbers.Find(new PerformerKey(0, avatar)))];
        Assert.Equal(1024, found.Count(static number => number is not null));
        Assert.Equal(0, numbers.Find(new PerformerKey(0, 0)));
    }

    [Fact]
    public void A_new_body_counts_when_it_stays()
    {
        var learner = new BodyLearner();
        BoneTransform[] pose = PoseOf(scale: 1);
        SkeletonBody first = learner.Observe(pose, SkeletonVariant.Neck1, known: null, endSites: null)!;
        Assert.Equal(pose[1].Position, first.Offsets[1]);
        Assert.Null(learner.Observe(pose, SkeletonVariant.Neck1, first, endSites: null));

        // One frame is different, as by an error of the network.
        BoneTransform[] taller = PoseOf(scale: 1.2f);
        Assert.Null(learner.Observe(taller, SkeletonVariant.Neck1, first, endSites: null));
        Assert.Null(learner.Observe(pose, SkeletonVariant.Neck1, first, endSites: null));

        SkeletonBody? second = null;
        for (int frame = 0; frame < 20; frame++)
            second ??= learner.Observe(taller, SkeletonVariant.Neck1, first, endSites: null);

        Assert.Equal(taller[1].Position, second!.Offsets[1]);
    }

    [Fact]
    public void Every_body_can_be_written_as_JSON()
    {
        var offsets = new Vector3[BoneHierarchy.BoneCount];
        offsets[1] = new Vector3(float.NaN, float.PositiveInfinity, 100);
        PerformerJson performer = new Performer(new PerformerKey(0, 0), "Char00", 0, new SkeletonBody(offsets)).ToJson();
        Assert.Equal([0, 0, 1], performer.Bones[1].Offset);
    }

    [Fact]
    public void A_body_is_never_learned_from_values_that_are_not_finite()
    {
        BoneTransform[] pose = PoseOf(scale: float.PositiveInfinity);
        Assert.Null(new BodyLearner().Observe(pose, SkeletonVariant.Neck1, known: null, endSites: null));
    }

    [Fact]
    public async Task Files_are_saved_in_the_folder_and_deleted_with_it()
    {
        string folder;
        using (var scratch = new ScratchFolder(1000))
        {
            folder = scratch.Path;
            string path = await scratch.SaveAsync(new MemoryStream([1, 2, 3]), TestContext.Current.CancellationToken);
            Assert.Equal(folder, Path.GetDirectoryName(path));
            Assert.Equal([1, 2, 3], await File.ReadAllBytesAsync(path, TestContext.Current.CancellationToken));
            if (!OperatingSystem.IsWindows())
                Assert.Equal(UnixFileMode.UserRead | UnixFileMode.UserWrite | UnixFileMode.UserExecute, File.GetUnixFileMode(Path.GetDirectoryName(folder)!));
        }

        Assert.False(Directory.Exists(folder));
    }

    [Fact]
    public async Task Files_together_have_a_limit_and_room_comes_back()
    {
        using var scratch = new ScratchFolder(1000);
        string first = await scratch.SaveAsync(new MemoryStream(new byte[800]), TestContext.Current.CancellationToken);
        ApiException refused = await Assert.ThrowsAsync<ApiException>(() => scratch.SaveAsync(new MemoryStream(new byte[201]), TestContext.Current.CancellationToken));
        Assert.Equal(507, refused.Status);
        Assert.Equal([first], Directory.GetFiles(scratch.Path));
        scratch.Delete(first);
        await scratch.SaveAsync(new MemoryStream(new byte[1000]), TestContext.Current.CancellationToken);
    }

    [Fact]
    public async Task An_upload_that_breaks_leaves_nothing()
    {
        using var scratch = new ScratchFolder(1000);
        await Assert.ThrowsAsync<ApiException>(() => scratch.SaveAsync(new BrokenStream(), TestContext.Current.CancellationToken));
        Assert.Empty(Directory.GetFiles(scratch.Path));
    }

    [Theory]
    [InlineData("127.0.0.1", "http://127.0.0.1:7080/?token=word")]
    [InlineData("0.0.0.0", "http://127.0.0.1:7080/?token=word")]
    [InlineData("::", "http://[::1]:7080/?token=word")]
    [InlineData("192.168.1.5", "http://192.168.1.5:7080/?token=word")]
    public void The_link_for_this_computer_works_there(string address, string expected) =>
        Assert.Equal(expected, PageLinks.OfThisComputer(new IPEndPoint(IPAddress.Parse(address), 7080), "word"));

    [Fact]
    public void Other_computers_get_links_only_if_they_can_connect()
    {
        Assert.Empty(PageLinks.OfOthers(new IPEndPoint(IPAddress.Loopback, 7080), token: null));
        Assert.Equal(["http://192.168.1.5:7080/?token=word"], PageLinks.OfOthers(new IPEndPoint(IPAddress.Parse("192.168.1.5"), 7080), "word"));
        Assert.DoesNotContain(PageLinks.OfOthers(new IPEndPoint(IPAddress.Any, 7080), "word"), static link => link.Contains("0.0.0.0", StringComparison.Ordinal));
    }

    [Fact]
    public void A_QR_code_needs_room() => Assert.Null(QrPicture.Create("http://192.168.1.5:7080/?token=0123456789abcdef0123456789abcdef", 20));

    [Fact]
    public void Observing_a_performer_allocates_nothing()
    {
        var performer = new LivePerformer(new PerformerKey(0, 0), "Char00", 0, reported: null);
        MotionFrame frame = Poses.Upright();
        performer.Take(frame, reported: null);
        Allocations.AssertNone(() => performer.Take(frame, reported: null));
    }

    private static BoneTransform[] PoseOf(float scale)
    {
        var pose = new BoneTransform[BoneHierarchy.BoneCount];
        SkeletonBody.GetDefault().CopyRestPose(pose);
        return [.. pose.Select(bone => bone with { Position = bone.Position * scale })];
    }

    private sealed class BrokenStream : MemoryStream
    {
        public override ValueTask<int> ReadAsync(Memory<byte> buffer, CancellationToken cancellationToken = default) => throw new IOException("The browser has gone.");
    }
}
