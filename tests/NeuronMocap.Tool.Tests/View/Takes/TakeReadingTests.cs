using NeuronMocap.Tool.Files;
using NeuronMocap.Tool.Tests.Files;
using NeuronMocap.Tool.View.Takes;

namespace NeuronMocap.Tool.Tests.View.Takes;

public sealed class TakeReadingTests
{
    // No file has such a name, and the runtime says so with an exception that nobody expects of a file.
    [Fact]
    public void A_fault_of_any_kind_is_told_and_ends_the_reading()
    {
        using var folder = new TemporaryFolder();
        using var take = new Take("t1", "walk.bvh", "\0", FileKind.Bvh);

        new TakeReading(take, folder["."]).Run();

        Assert.EndsWith(".", Assert.Single(take.Problems), StringComparison.Ordinal);
        Assert.Equal(1, take.Progress);
    }

    [Fact]
    public void A_take_that_was_closed_is_not_complete()
    {
        using var folder = new TemporaryFolder();
        Files.Takes.Actor(2).Save(folder["walk.bvh"]);
        var take = new Take("t1", "walk.bvh", folder["walk.bvh"], FileKind.Bvh);
        take.Dispose();

        new TakeReading(take, folder["."]).Run();

        Assert.Empty(take.Problems);
        Assert.Equal(0, take.Progress);
    }
}
