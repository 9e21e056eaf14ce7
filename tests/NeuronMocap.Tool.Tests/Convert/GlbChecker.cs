using System.Diagnostics;
using System.Globalization;
using System.Numerics;
using System.Text.Json;

namespace NeuronMocap.Tool.Tests.Convert;

/// <summary>Reads GLB files with the validator of Khronos, with three.js and with Blender, if they are there.</summary>
internal static class GlbChecker
{
    // Blender reads its add-ons first.
    private static readonly TimeSpan Limit = TimeSpan.FromMinutes(2);

    /// <summary>What node found in a file: the messages of the validator, and the joints of each figure at each time, in metres.</summary>
    public sealed record Report(string[] Issues, Figure[] Figures);

    public sealed record Figure(string[] Names, string[] Clips, Vector3[][] Joints, Vector3 Size);

    /// <summary>Validates files and loads them with three.js. Skips the test without node or its packages.</summary>
    public static async Task<Report[]> CheckAsync(string[] files, double[] times)
    {
        Assert.SkipUnless(InstalledPrograms.Have("node"), "node is not installed.");
        string page = Repository.PathOf("web");
        Assert.SkipUnless(Directory.Exists(Path.Combine(page, "node_modules", "gltf-validator")), "The packages of the page are not installed: build the program.");
        string output = await RunAsync("node", [Repository.PathOf("tests", "Shared", "Gltf", "check.mjs"), page, Join(times), .. files]);
        using var json = JsonDocument.Parse(output);
        return [.. json.RootElement.EnumerateArray().Select(static report => new Report(
            Texts(report.GetProperty("issues")),
            [.. report.GetProperty("figures").EnumerateArray().Select(static figure => new Figure(
                Texts(figure.GetProperty("names")),
                Texts(figure.GetProperty("clips")),
                [.. figure.GetProperty("joints").EnumerateArray().Select(static pose => pose.EnumerateArray().Select(Point).ToArray())],
                Point(figure.GetProperty("size"))))]))];
    }

    /// <summary>Imports a file into Blender. Returns the joints of each armature by name, at each time. Skips the test without Blender and its NumPy.</summary>
    public static async Task<Dictionary<string, Dictionary<string, Vector3>[]>> ImportAsync(string file, double rate, double[] times)
    {
        Assert.SkipUnless(InstalledPrograms.Have("blender"), "blender is not installed.");
        string script = Repository.PathOf("tests", "Shared", "Gltf", "joints.py");
        string output = await RunAsync(
            "blender", ["-b", "--factory-startup", "--python-exit-code", "1", "--python", script, "--", file, rate.ToString(CultureInfo.InvariantCulture), Join(times)]);
        Assert.SkipWhen(output.Contains("LACKS NumPy", StringComparison.Ordinal), "Blender has no NumPy: install python3-numpy.");
        using var json = JsonDocument.Parse(output.Split('\n').Single(static line => line.StartsWith("JOINTS ", StringComparison.Ordinal))["JOINTS ".Length..]);
        return json.RootElement.EnumerateArray().ToDictionary(
            static armature => armature.GetProperty("name").GetString()!,
            static armature => armature.GetProperty("joints").EnumerateArray()
                .Select(static pose => pose.EnumerateObject().ToDictionary(static joint => joint.Name, static joint => Point(joint.Value))).ToArray());
    }

    private static async Task<string> RunAsync(string program, string[] arguments)
    {
        var start = new ProcessStartInfo(program, arguments) { UseShellExecute = false, RedirectStandardOutput = true, RedirectStandardError = true };
        using Process process = Process.Start(start)!;
        try
        {
            CancellationToken token = TestContext.Current.CancellationToken;
            Task<string> output = process.StandardOutput.ReadToEndAsync(token), error = process.StandardError.ReadToEndAsync(token);
            await process.WaitForExitAsync(token).WaitAsync(Limit, token);
            Assert.True(process.ExitCode == 0, $"{program}: {await error}{await output}");
            return await output;
        }
        finally
        {
            if (!process.HasExited)
                process.Kill(entireProcessTree: true);
        }
    }

    private static string Join(double[] times) => string.Join(',', times.Select(static time => time.ToString("R", CultureInfo.InvariantCulture)));

    private static string[] Texts(JsonElement texts) => [.. texts.EnumerateArray().Select(static text => text.GetString()!)];

    private static Vector3 Point(JsonElement values) => new(values[0].GetSingle(), values[1].GetSingle(), values[2].GetSingle());
}
