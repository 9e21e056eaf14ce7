using System.Collections.Concurrent;
using System.Globalization;
using NeuronMocap.Desktop.Tests.Infrastructure;
using NeuronMocap.Server;

namespace NeuronMocap.Desktop.Tests;

/// <summary>Closes windows while three performers arrive at 120 Hz.</summary>
public sealed class ClosingTests(ITestOutputHelper output)
{
    private const int Rounds = 9;

    // Of the closing in the middle. Twenty times the usual time; a stop that waits in vain takes longer, because the reader's own time-out is 2 s.
    private const double LongestUsual = 2000;

    [Fact]
    public Task Sample_closes_at_once_while_frames_arrive() => CloseAsync(
        Programs.SampleTitle,
        Programs.Sample,
        server => [$"{server.LocalEndPoint}"],
        button: null,
        "^[1-9][0-9]* frames/s received, [1-9][0-9]* frames/s shown$");

    // The callbacks of this program wait for the thread of the window.
    [Fact]
    public Task Program_for_the_vendors_wrapper_closes_at_once_while_callbacks_invoke() => CloseAsync(
        Programs.WrapperTitle,
        Programs.Wrapper,
        server => [$"{server.LocalEndPoint!.Address}", $"{server.LocalEndPoint.Port}"],
        button: "Connect",
        "^[1-9][0-9]+ frames$");

    private async Task CloseAsync(string title, string executable, Func<Broadcaster, string[]> arguments, string? button, string frames)
    {
        Screen.Require();
        using Broadcaster server = Broadcaster.StartDemo(avatars: 3, frameRate: 120);
        var times = new ConcurrentBag<double>();
        int lanes = Math.Min(Environment.ProcessorCount, 4);
        int round = 0;
        int failuresOfMono = 0;
        await Task.WhenAll(Enumerable.Range(0, lanes).Select(_ => RunLaneAsync()));

        double[] sorted = [.. times.Order()];
        output.WriteLine(string.Create(
            CultureInfo.InvariantCulture,
            $"{sorted.Length} closings: quickest {sorted[0]:0} ms, median {sorted[sorted.Length / 2]:0} ms, 90 % {sorted[sorted.Length * 9 / 10]:0} ms, longest {sorted[^1]:0} ms"));
        Assert.Equal(Rounds, sorted.Length);
        Assert.InRange(failuresOfMono, 0, Rounds / 3);
        Assert.InRange(sorted[sorted.Length / 2], 0, LongestUsual);

        async Task RunLaneAsync()
        {
            using Screen screen = await Screen.OpenAsync();
            while (Interlocked.Increment(ref round) <= Rounds)
            {
                using WindowProgram program = await WindowProgram.StartAsync(screen, title, [executable, .. arguments(server)]);
                if (button is not null)
                    await program.ClickAsync(button);

                await program.UntilTextAsync(frames);
                times.Add((await program.CloseAsync(allowsFailureOfMono: true)).TotalMilliseconds);
                if (program.HasMonoFailed)
                    Interlocked.Increment(ref failuresOfMono);
                else
                    Assert.Equal("", program.Output);
            }
        }
    }
}
