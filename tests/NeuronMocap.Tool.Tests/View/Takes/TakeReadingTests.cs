using NeuronMocap.Tool.Files;
using NeuronMocap.Tool.Tests.Files;
using NeuronMocap.Tool.Tests.Infrastructure;
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

    [Theory]
    [InlineData("walk.bvh")]
    [InlineData("walk.calc")]
    public async Task A_defect_of_a_row_is_one_sentence(string name)
    {
        using var folder = new TemporaryFolder();
        Files.Takes.Actor(3).Save(folder["walk.bvh"]);
        if (name != "walk.bvh")
            Assert.Equal(0, (await ToolRunner.RunAsync("convert", folder["walk.bvh"], folder[name])).ExitCode);
        await File.AppendAllTextAsync(folder[name], "1 2 3\r\n", TestContext.Current.CancellationToken);
        using var take = new Take("t1", name, folder[name], FileKinds.Recognize(folder[name]));

        new TakeReading(take, folder["."]).Run();

        Assert.Contains(take.Problems, static problem => problem.Contains("A row has 3 values instead of", StringComparison.Ordinal));
        Assert.All(take.Problems, static problem => Assert.Matches(@"^Line \d+, column \d+: [A-Z][^.]*[^.]\.$", problem));
    }
}
