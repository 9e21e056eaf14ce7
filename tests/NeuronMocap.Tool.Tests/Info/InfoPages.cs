using System.Text.Json;
using NeuronMocap.Protocol;
using NeuronMocap.Tool.Tests.Files;
using NeuronMocap.Tool.Tests.Infrastructure;

namespace NeuronMocap.Tool.Tests.Info;

/// <summary>The verb's output for files in a folder of the test.</summary>
public abstract class InfoPages : IDisposable
{
    private protected TemporaryFolder Folder { get; } = new();

    public void Dispose()
    {
        Folder.Dispose();
        GC.SuppressFinalize(this);
    }

    protected async Task<string[]> PageAsync(string name, params string[] options)
    {
        ToolResult result = await ToolRunner.RunAsync(["info", Folder[name], .. options]);
        Assert.Empty(result.Error);
        Assert.Equal(0, result.ExitCode);
        return result.Output;
    }

    protected async Task<JsonElement> JsonAsync(string name)
    {
        ToolResult result = await ToolRunner.RunAsync("info", Folder[name], "--json");
        Assert.Empty(result.Error);
        Assert.Equal(0, result.ExitCode);
        return JsonDocument.Parse(Assert.Single(result.Output)).RootElement;
    }

    protected static string Fact(string[] page, string label, string? after = null) => page
        .SkipWhile(line => after is not null && line != after)
        .First(line => line.StartsWith($"  {label} ", StringComparison.Ordinal))[(label.Length + 2)..]
        .Trim();

    protected static byte[] Packet(int avatar, string name, uint frame)
    {
        MotionFrame upright = Poses.Upright(frame);
        byte[] packet = new byte[upright.Header.PacketSize];
        PacketEncoder.WriteMotion(
            packet, upright.Header with { AvatarIndex = avatar, AvatarName = new AvatarName(name), FrameIndex = frame }, upright.Values);
        return packet;
    }
}
