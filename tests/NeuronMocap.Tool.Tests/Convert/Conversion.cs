using NeuronMocap.Tool.Tests.Infrastructure;

namespace NeuronMocap.Tool.Tests.Convert;

/// <summary>Runs the verb where it succeeds.</summary>
internal static class Conversion
{
    /// <summary>The line that says what the new file holds.</summary>
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
