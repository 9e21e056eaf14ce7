using System.Text.Json;
using NeuronMocap.Bvh;
using NeuronMocap.Calculation;
using NeuronMocap.Recording;
using NeuronMocap.Tool.Tests.Files;
using NeuronMocap.Tool.Tests.Infrastructure;

namespace NeuronMocap.Tool.Tests.Convert;

/// <summary>All verbs find the same rate in the same stream.</summary>
public sealed class FrameTimeTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Theory]
    [InlineData(60, 240, 1)]
    [InlineData(60, 240, 2)]
    [InlineData(96, 300, 1)]
    [InlineData(120, 90, 1)]
    [InlineData(110, 400, 1)]
    [InlineData(60, 2, 1)]
    [InlineData(90, 10, 1)]
    public async Task Export_conversion_and_info_find_the_same_frame_time(double rate, int frames, int step)
    {
        Record("take.nmrec", rate, frames, (uint)step);
        await Conversion.ConvertAsync(_folder["take.nmrec"], _folder["converted.bvh"]);
        ToolResult play = await ToolRunner.RunAsync("play", _folder["take.nmrec"], "--speed", "max", "--quiet", "--export", _folder["exported.bvh"]);
        Assert.Equal(0, play.ExitCode);
        JsonElement take = await InfoAsync("take.nmrec");

        BvhFrameTime converted = BvhDocument.Load(_folder["converted.bvh"]).FrameTime;
        Assert.Equal(converted, BvhDocument.Load(_folder["exported.bvh"]).FrameTime);
        Assert.Equal(converted.FrameRate, take.GetProperty("take").GetProperty("frameRate").GetDouble(), 1e-3);
        Assert.Equal(take.GetProperty("avatars")[0].GetProperty("rate").GetDouble(), take.GetProperty("take").GetProperty("measuredRate").GetDouble(), 1e-3);
        if (frames > 10)
            Assert.Equal(rate, converted.FrameRate, 0.2);
        if (rate is 60 or 96 or 120 && frames > 10)
            Assert.Equal(rate, converted.FrameRate, 1e-9);
    }

    [Fact]
    public async Task Calculation_rows_have_the_rate_of_the_poses()
    {
        Record("take.nmrec", 60, 240, step: 2);
        await Conversion.ConvertAsync(_folder["take.nmrec"], _folder["rows.calc"]);
        using CalculationFileReader reader = CalculationFileReader.Open(_folder["rows.calc"]);
        Assert.Equal(60, reader.FrameRate);
    }

    // The walk of the demo at 60 Hz. Its first eight frames arrived together.
    [Fact]
    public async Task The_sample_take_has_60_frames_a_second()
    {
        string walk = Repository.PathOf("samples", "takes", "walk.nmrec");
        await Conversion.ConvertAsync(walk, _folder["converted.bvh"]);
        ToolResult play = await ToolRunner.RunAsync("play", walk, "--speed", "max", "--quiet", "--export", _folder["exported.bvh"]);
        Assert.Equal(0, play.ExitCode);
        Assert.Equal(new BvhFrameTime(1, 60), BvhDocument.Load(_folder["converted.bvh"]).FrameTime);
        Assert.Equal(new BvhFrameTime(1, 60), BvhDocument.Load(_folder["exported.bvh"]).FrameTime);
    }

    private async Task<JsonElement> InfoAsync(string name)
    {
        ToolResult info = await ToolRunner.RunAsync("info", _folder[name], "--json");
        return JsonDocument.Parse(Assert.Single(info.Output)).RootElement;
    }

    // Motion and calculation data. The first frames arrive together, some are lost, and each is late by up to 4 ms.
    private void Record(string name, double rate, int frames, uint step)
    {
        var random = new Random(1);
        using RecordingWriter writer = RecordingWriter.Create(_folder[name]);
        writer.OpenConnection(TimeSpan.Zero, new RecordedConnection(0, TransportKind.Tcp, "127.0.0.1:50000", "127.0.0.1:7001"));
        TimeSpan time = TimeSpan.Zero;
        for (uint frame = 0; frame < frames; frame++)
        {
            double opening = frames > 50 ? 0.12 : 0;
            var arrival = TimeSpan.FromSeconds(Math.Max(frame / rate, opening) + (random.NextDouble() * 0.004));
            time = arrival > time ? arrival : time;
            if (frame % 37 == 30)
                continue;

            writer.WriteBytes(time, 0, FrameServer.Motion(frame * step, new float[354]));
            writer.WriteBytes(time, 0, FrameServer.Calculation(frame * step, new float[946]));
        }
    }
}
