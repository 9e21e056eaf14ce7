using System.Text.Json;
using NeuronMocap.Tool.Tests.Info;
using NeuronMocap.Tool.Tests.Infrastructure;

namespace NeuronMocap.Data.Tests.Tool;

public sealed class TakeInfoTests : InfoPages
{
    [Fact]
    public async Task A_real_take_is_described()
    {
        File.Copy(Fixtures.Require("test-take", "test.bvh"), Folder["test.bvh"]);
        string[] page = await PageAsync("test.bvh");

        Assert.StartsWith("120 Hz: the file says 0.008 s, which is 1/120 s rounded (125 Hz as stated)", Fact(page, "frame rate"), StringComparison.Ordinal);
        Assert.StartsWith("Spine3", Fact(page, "bone names"), StringComparison.Ordinal);
        Assert.Contains("  154 of the 180 values never change", page);
        Assert.StartsWith("0.000 m", Fact(page, "ground"), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("mixed")]
    [InlineData("text")]
    [InlineData("studio-354")]
    [InlineData("calculation")]
    [InlineData("zero-count")]
    public async Task A_dump_of_a_stream_is_described(string name)
    {
        File.Copy(Fixtures.Require("streams", name + ".bin"), Folder["stream.bin"]);
        JsonElement json = await JsonAsync("stream.bin");
        Assert.Equal("raw", json.GetProperty("kind").GetString());
        Assert.NotEmpty(json.GetProperty("stream").GetProperty("formats").EnumerateArray());
        Assert.Equal(0, (await ToolRunner.RunAsync("info", Folder["stream.bin"])).ExitCode);
    }

    [Fact]
    public async Task A_real_calculation_export_is_described()
    {
        File.Copy(Fixtures.Require("calc", "salsa_left_Char00.calc"), Folder["salsa.calc"]);
        JsonElement json = await JsonAsync("salsa.calc");
        Assert.Equal("calculation", json.GetProperty("kind").GetString());
        Assert.Equal(269, json.GetProperty("take").GetProperty("frames").GetInt32());
        Assert.Equal(946, json.GetProperty("take").GetProperty("columns").GetInt32());
        Assert.InRange(json.GetProperty("boneSizes").GetProperty("upperLeg").GetDouble(), 0.3, 0.6);
    }
}
