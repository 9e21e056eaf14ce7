using NeuronMocap.Skeleton;
using NeuronMocap.Tool.Files;
using NeuronMocap.Tool.Tests.Files;
using NeuronMocap.Tool.View.Takes;

namespace NeuronMocap.Tool.Tests.View.Takes;

public sealed class TakeTimesJsonTests
{
    [Fact]
    public async Task A_take_is_complete_when_its_file_was_read()
    {
        using var folder = new TemporaryFolder();
        using var take = new Take("t1", "walk.bvh", folder["walk.bvh"], FileKind.Bvh);
        var writer = new PerformerWriter(size => new RecordFile(folder["."], size), "t1-0", 0, new AvatarName("Actor"), default, SkeletonBody.GetDefault());
        take.Add(writer.Performer);
        using var end = new ManualResetEventSlim();
        take.Start(end.Wait);

        Assert.False(TakeTimesJson.Of(take, writer.Performer).IsComplete);
        end.Set();
        await take.Completion;
        Assert.True(TakeTimesJson.Of(take, writer.Performer).IsComplete);
    }
}
