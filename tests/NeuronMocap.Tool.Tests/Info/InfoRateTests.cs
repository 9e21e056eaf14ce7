using System.Text.Json;
using NeuronMocap.Bvh;
using NeuronMocap.Recording;
using NeuronMocap.Tool.Tests.Files;
using NeuronMocap.Tool.Tests.Infrastructure;

namespace NeuronMocap.Tool.Tests.Info;

public sealed class InfoRateTests : InfoPages
{
    // Two frames in the middle are lost. The bytes have no times, so the given rate applies, and not a rate derived from the loss.
    [Theory]
    [InlineData("60", 60)]
    [InlineData("59.94", 59.94)]
    [InlineData(null, 120)]
    public async Task The_rate_of_bytes_without_times_can_be_given(string? given, double rate)
    {
        await File.WriteAllBytesAsync(
            Folder["stream.bin"],
            [.. Enumerable.Range(0, 20).Where(static frame => frame is not (10 or 11)).SelectMany(static frame => Packet(0, "Anna", (uint)frame))],
            TestContext.Current.CancellationToken);
        string[] option = given is null ? [] : ["--rate", given];
        ToolResult info = await ToolRunner.RunAsync(["info", Folder["stream.bin"], "--json", .. option]);
        JsonElement take = JsonDocument.Parse(Assert.Single(info.Output)).RootElement.GetProperty("take");
        Assert.Equal((20, rate), (take.GetProperty("frames").GetInt32(), take.GetProperty("frameRate").GetDouble()));

        Assert.Equal(0, (await ToolRunner.RunAsync(["convert", Folder["stream.bin"], Folder["stream.bvh"], .. option])).ExitCode);
        Assert.Equal(rate, BvhDocument.Load(Folder["stream.bvh"]).FrameRate, 1e-3);
        Assert.Equal(0, (await ToolRunner.RunAsync(["convert", Folder["stream.bin"], Folder["stream.nmrec"], .. option])).ExitCode);
        using (RecordingReader reader = RecordingReader.Open(Folder["stream.nmrec"]))
            Assert.Equal(17 / rate, reader.Duration.TotalSeconds, 1e-6);

        Assert.Equal(0, (await ToolRunner.RunAsync(["plot", Folder["stream.bin"], Folder["stream.svg"], .. option])).ExitCode);
        Assert.Contains(FormattableString.Invariant($"20 frames at {rate:0.##} Hz"), await File.ReadAllTextAsync(Folder["stream.svg"], TestContext.Current.CancellationToken), StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_rate_is_refused_for_files_with_times()
    {
        Takes.StraightWalk(frames: 3).Save(Folder["walk.bvh"]);
        ToolResult result = await ToolRunner.RunAsync("info", Folder["walk.bvh"], "--rate", "60");
        Assert.Equal(1, result.ExitCode);
        Assert.Contains("walk.bvh has its own times", Assert.Single(result.Error), StringComparison.Ordinal);
    }

    // An export has no field for its rate. 60 Hz become 120 unless the rate is given.
    [Fact]
    public async Task The_rate_of_a_calculation_export_can_be_given()
    {
        Takes.Actor(60).Save(Folder["take.bvh"]);
        Assert.Equal(0, (await ToolRunner.RunAsync("convert", Folder["take.bvh"], Folder["take.calc"])).ExitCode);
        ToolResult info = await ToolRunner.RunAsync("info", Folder["take.calc"], "--json", "--rate", "60");
        Assert.Equal(60, JsonDocument.Parse(Assert.Single(info.Output)).RootElement.GetProperty("take").GetProperty("frameRate").GetDouble());
        Assert.Equal(0, (await ToolRunner.RunAsync("convert", Folder["take.calc"], Folder["back.bvh"], "--rate", "60")).ExitCode);
        Assert.Equal(60, BvhDocument.Load(Folder["back.bvh"]).FrameRate);
        Assert.Equal(0, (await ToolRunner.RunAsync("convert", Folder["take.calc"], Folder["back.nmrec"], "--rate", "60")).ExitCode);
        using RecordingReader reader = RecordingReader.Open(Folder["back.nmrec"]);
        Assert.Equal(59 / 60.0, reader.Duration.TotalSeconds, 1e-6);
    }
}
