using NeuronMocap.Tool.Output;
using NeuronMocap.Tool.Terminal;
using NeuronMocap.Tool.Tests.Files;
using NeuronMocap.Tool.Tests.Infrastructure;

namespace NeuronMocap.Tool.Tests.Terminal;

public sealed class QuantityTests
{
    [Theory]
    [InlineData(0, "0 frames")]
    [InlineData(1, "1 frame")]
    [InlineData(2000, "2,000 frames")]
    public void A_count_of_one_is_singular(long count, string expected) => Assert.Equal(expected, Quantity.Count(count, "frame"));

    [Fact]
    public void An_irregular_plural_is_given() => Assert.Equal("2 replies", Quantity.Count(2, "reply", "replies"));

    [Fact]
    public void The_last_line_of_watch_counts_one_byte() => Assert.Equal(
        "1 motion and 1 calculation frame in 0.0 s; lost 0, dropped 0, skipped 1 byte, rejected 1 message.",
        LineOutput.DescribeEnd(new ReaderStatistics { MotionFrames = 1, CalculationFrames = 1, BytesSkipped = 1, RejectedMessages = 1 }));

    [Fact]
    public async Task A_plot_of_one_frame_says_so()
    {
        using var folder = new TemporaryFolder();
        Takes.Actor(1).Save(folder["one.bvh"]);
        Assert.Empty((await ToolRunner.RunAsync("plot", folder["one.bvh"], folder["one.svg"])).Error);
        Assert.Contains("  ·  1 frame at 60 Hz", await File.ReadAllTextAsync(folder["one.svg"], TestContext.Current.CancellationToken), StringComparison.Ordinal);
    }

    // The file declares one frame and has a row of one value.
    [Fact]
    public async Task The_defects_of_a_file_count_one_frame_and_one_value()
    {
        using var folder = new TemporaryFolder();
        string path = folder.Write("one.bvh", Takes.TwoJoints.Replace("Frames: 3", "Frames: 1", StringComparison.Ordinal) + "\n7\n");
        string page = string.Join('\n', (await ToolRunner.RunAsync("info", path)).Output);
        Assert.Contains("The file declares '1' frame but has 3 rows", page, StringComparison.Ordinal);
        Assert.Contains("A row has 1 value instead of 7", page, StringComparison.Ordinal);
    }
}
