using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Tests.Terminal;

public sealed class ProgressLineTests
{
    [Fact]
    public void Redirected_output_has_no_bar()
    {
        using var error = new StringWriter();
        using (var streams = new StandardStreams(Stream.Null, error, IsTerminal: true))
        using (var progress = new ProgressLine(streams, "reading take.bvh", TimeSpan.Zero))
            progress.Report(0.5);

        Assert.Empty(error.ToString());
    }

    [Fact]
    public void Short_work_has_no_bar()
    {
        using var error = new StringWriter();
        using (var streams = new StandardStreams(Stream.Null, error, IsTerminal: false) { IsErrorTerminal = true })
        using (var progress = new ProgressLine(streams, "reading take.bvh", TimeSpan.FromHours(1)))
            progress.Report(0.5);

        Assert.Empty(error.ToString());
    }

    [Fact]
    public void The_bar_shows_progress_and_is_removed_at_the_end()
    {
        using var error = new SharedWriter();
        using (var streams = new StandardStreams(Stream.Null, error, IsTerminal: false) { IsErrorTerminal = true })
        using (var progress = new ProgressLine(streams, "reading [take]\e.bvh", TimeSpan.Zero))
        {
            progress.Report(0.42);
            SpinUntil(() => error.ToString().Contains("42%", StringComparison.Ordinal));
            progress.Report(0.9);
            progress.Report(0.01);
            SpinUntil(() => error.ToString().Contains("step 2", StringComparison.Ordinal));
        }

        string text = error.ToString();
        Assert.Contains("reading [take]·.bvh", text, StringComparison.Ordinal);
        Assert.Contains(" left", text, StringComparison.Ordinal);

        // The cursor is visible again, and the line is erased.
        Assert.True(text.LastIndexOf("\e[?25h", StringComparison.Ordinal) > text.LastIndexOf("\e[?25l", StringComparison.Ordinal));
        Assert.True(text.LastIndexOf("\e[2K", StringComparison.Ordinal) > text.LastIndexOf('%'), text);
    }

    [Theory]
    [InlineData(0.5, 10, "10 s left")]
    [InlineData(0.25, 30, "1 min 30 s left")]
    [InlineData(1, 30, "0 s left")]
    [InlineData(0, 30, "")]
    [InlineData(1e-300, 30, "")]
    public void The_remaining_time_follows_from_the_elapsed_time(double value, double seconds, string expected) =>
        Assert.Equal(expected, ProgressLine.DescribeRest(value, TimeSpan.FromSeconds(seconds)));

    // The bar has its own thread.
    private sealed class SharedWriter : StringWriter
    {
        private readonly Lock _lock = new();

        public override void Write(char value)
        {
            lock (_lock)
                base.Write(value);
        }

        public override void Write(string? value)
        {
            lock (_lock)
                base.Write(value);
        }

        public override string ToString()
        {
            lock (_lock)
                return base.ToString();
        }
    }

    private static void SpinUntil(Func<bool> condition) => Assert.True(SpinWait.SpinUntil(condition, TimeSpan.FromMinutes(1)));
}
