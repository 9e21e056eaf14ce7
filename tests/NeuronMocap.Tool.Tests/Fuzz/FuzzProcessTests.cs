using NeuronMocap.Fuzz;
using NeuronMocap.Fuzz.Targets;
using NeuronMocap.Tool.Tests.Infrastructure;

namespace NeuronMocap.Tool.Tests.Fuzz;

public sealed class FuzzProcessTests
{
    private const string Program = "NeuronMocap.Fuzz";

    [Fact]
    public async Task A_run_without_failures_ends_with_0_and_a_line_for_each_target()
    {
        using var fuzz = new ToolProcess(Program, "--bytes", "600000", "--seed", "3");
        string output = await fuzz.Output.ReadToEndAsync(TestContext.Current.CancellationToken);

        Assert.Equal(0, await fuzz.WaitForExitAsync());
        Assert.StartsWith("seed 3; ", output, StringComparison.Ordinal);
        foreach (FuzzTarget target in TargetList.All)
            Assert.Contains($"\n{target.Name} ", output, StringComparison.Ordinal);

        Assert.Contains($"0 of {TargetList.All.Count} targets failed", output, StringComparison.Ordinal);
    }

    [Fact]
    public async Task Several_seeds_run_one_after_the_other()
    {
        using var fuzz = new ToolProcess(Program, "--bytes", "100000", "--seed", "5", "--seeds", "2", "--target", "scanner");
        string output = await fuzz.Output.ReadToEndAsync(TestContext.Current.CancellationToken);

        Assert.Equal(0, await fuzz.WaitForExitAsync());
        Assert.StartsWith("seed 5; ", output, StringComparison.Ordinal);
        Assert.Contains("\nseed 6; ", output, StringComparison.Ordinal);
        Assert.EndsWith("2 of 2 seeds run; 0 of them failed\n", output, StringComparison.Ordinal);
    }

    [Fact]
    public async Task Seed_of_the_day_is_printed_and_is_the_date()
    {
        DateTime before = DateTime.UtcNow;
        using var fuzz = new ToolProcess(Program, "--bytes", "1000", "--seed", "today", "--target", "scanner");
        string? line = await fuzz.Output.ReadLineAsync(TestContext.Current.CancellationToken);

        Assert.Equal(0, await fuzz.WaitForExitAsync());
        string[] days = [$"seed {before:yyyyMMdd};", $"seed {DateTime.UtcNow:yyyyMMdd};"];
        Assert.Contains(line![..14], days);
    }

    [Theory]
    [InlineData("--target", "nothing")]
    [InlineData("--bytes", "0")]
    [InlineData("--seed", "x")]
    [InlineData("--seed", "-1")]
    [InlineData("--seeds", "0")]
    [InlineData("--data", "/no/such/folder")]
    public async Task Bad_usage_ends_with_2(params string[] args)
    {
        using var fuzz = new ToolProcess(Program, args);
        Assert.Equal(2, await fuzz.WaitForExitAsync());
        Assert.NotEmpty(await fuzz.ReadErrorAsync());
    }

    [Theory]
    [InlineData("INT", 130)]
    [InlineData("TERM", 143)]
    public async Task A_signal_ends_a_long_run_with_its_number_and_the_summary(string signal, int code)
    {
        if (OperatingSystem.IsWindows())
            Assert.Skip("There are no signals to send.");
        if (signal is "INT" && ToolProcess.IgnoresInterrupt())
            Assert.Skip("The shell that runs the tests in the background has switched SIGINT off, and programs inherit that.");

        using var fuzz = new ToolProcess(Program, "--bytes", "1000000000000");
        await fuzz.Output.ReadLineAsync(TestContext.Current.CancellationToken);
        Signals.Send(signal, fuzz.Id);
        string rest = await fuzz.Output.ReadToEndAsync(TestContext.Current.CancellationToken);

        Assert.Equal(code, await fuzz.WaitForExitAsync());
        Assert.Contains($"0 of {TargetList.All.Count} targets failed", rest, StringComparison.Ordinal);
    }

    [Fact]
    public void A_failing_input_ends_with_1_and_leaves_an_input_that_repeats_it()
    {
        string folder = Path.Combine(Path.GetTempPath(), Path.GetRandomFileName());
        try
        {
            FuzzTarget[] targets = [PlantedFaults.Get("exception")];
            Assert.Equal(1, new FuzzCommand(targets).Invoke(["--bytes", "1000000", "--seed", "7", "--output", folder]));

            string input = Assert.Single(Directory.GetFiles(folder, "exception-7-*.bin"));
            Assert.Equal(PlantedFaults.Trigger, File.ReadAllBytes(input));
            string text = File.ReadAllText(Path.ChangeExtension(input, ".txt"));
            Assert.Contains("IndexOutOfRangeException", text, StringComparison.Ordinal);
            Assert.Equal(1, new FuzzCommand(targets).Invoke(["--replay", input]));
            Assert.Equal(0, new FuzzCommand([PlantedFaults.Get("none")]).Invoke(["--replay", input]));
        }
        finally
        {
            Directory.Delete(folder, recursive: true);
        }
    }
}
