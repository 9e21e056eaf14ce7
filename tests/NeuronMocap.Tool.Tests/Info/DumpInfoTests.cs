using System.Text.Json;
using NeuronMocap.Protocol;
using NeuronMocap.Tool.Tests.Infrastructure;

namespace NeuronMocap.Tool.Tests.Info;

public sealed class DumpInfoTests : InfoPages
{
    // Dumps of text streams that lack the start of a line.
    [Theory]
    [InlineData("", "without the avatar's number and name")]
    [InlineData("Char00 A ", "begin with a word instead of the avatar's number")]
    public async Task A_text_dump_without_an_avatar_names_what_is_missing(string lead, string said)
    {
        string line = lead + string.Join(' ', Enumerable.Range(0, 354).Select(static value => $"{value}.50")) + "||\r\n";
        await File.WriteAllTextAsync(Folder["text.bin"], string.Concat(Enumerable.Repeat(line, 5)), TestContext.Current.CancellationToken);
        ToolResult result = await ToolRunner.RunAsync("info", Folder["text.bin"]);

        Assert.Equal(1, result.ExitCode);
        Assert.Empty(result.Output);
        string error = string.Join(' ', result.Error);
        Assert.Contains(said, error, StringComparison.Ordinal);
        Assert.Contains("0 Char00 0.00 93.02", error, StringComparison.Ordinal);
    }

    // In a frame with positions near the largest number, the extent is infinite.
    [Fact]
    public async Task A_take_of_infinite_extent_gives_valid_JSON()
    {
        byte[] packet = new byte[64 + (354 * sizeof(float))];
        float[] values = [float.MaxValue, -float.MaxValue, float.MaxValue, .. new float[351]];
        PacketEncoder.WriteMotion(packet, new MotionHeader { Version = DataVersion.New, HasDisplacement = true, AvatarName = new AvatarName("Char00") }, values);
        await File.WriteAllBytesAsync(Folder["far.bin"], packet, TestContext.Current.CancellationToken);
        JsonElement json = await JsonAsync("far.bin");

        Assert.Equal("raw", json.GetProperty("kind").GetString());
    }
}
