using NeuronMocap.Tool.Tests.Infrastructure;

namespace NeuronMocap.Tool.Tests.Convert;

/// <summary>Runs the verb and expects success.</summary>
internal static class Conversion
{
    /// <summary>Returns the line that describes the new file.</summary>
    public static async Task<string> ConvertAsync(string input, string output, params string[] options)
    {
        ToolResult result = await ToolRunner.RunAsync(["convert", input, output, .. options]);
        Assert.True(result.ExitCode == 0, string.Join('\n', result.Error));
        Assert.Empty(result.Output);
        string summary = Assert.Single(result.Error);
        Assert.StartsWith($"neuron-mocap: {Path.GetFileName(output)}: ", summary, StringComparison.Ordinal);
        return summary;
    }
}
