using System.Diagnostics;
using System.Globalization;
using NeuronMocap.Benchmarks.Harness;
using NeuronMocap.Benchmarks.Peers;

namespace NeuronMocap.Benchmarks.Macro;

// From just before a process starts to the first frame in its handler. The floor is the same kind of process that receives the frame from a raw socket.
// Also the first picture of the program, in a terminal.
internal sealed class Start(DirectoryInfo programs, int runs, Report report)
{
    private const string Figure = "ms";

    public async Task<int> RunAsync()
    {
        report.Begin($"Milliseconds from just before the start of a process to its first frame or picture, {runs} runs.");
        foreach ((string name, string? @case, double? aim) in ((string, string?, double?)[])
            [
                ("first-frame-jit", "first frame, JIT", null),
                ("first-frame-ready", "first frame, ReadyToRun", null),
                ("first-frame-aot", "first frame, AOT", 20),
            ])
        {
            if (Find(name, "FirstFrame") is not { } program)
                continue;

            Aim[] aims = aim is { } limit ? [new Aim(Figure, limit)] : [];
            Way raw = new("raw socket", () => FirstFrameAsync(program, "raw"));
            report.Add(await Alternation.RunAsync(@case!, runs, raw, [new Way("library", () => FirstFrameAsync(program, "library"))], aims));
        }

        List<Way> pictures = [];
        foreach ((string name, string way) in ((string, string)[])[("tool-jit", "JIT"), ("tool-ready", "ReadyToRun")])
        {
            if (Find(name, "neuron-mocap") is { } program)
                pictures.Add(new Way(way, () => FirstPictureAsync(program)));
        }

        if (pictures.Count > 0 && OperatingSystem.IsLinux())
            report.Add(await Alternation.RunAsync("first picture of watch demo", runs, new Way("the program's version", () => VersionAsync(pictures.Count > 1 ? "tool-ready" : "tool-jit")), pictures, [new Aim(Figure, 400)]));

        return report.End();
    }

    private FileInfo? Find(string folder, string name)
    {
        var file = new FileInfo(Path.Combine(programs.FullName, folder, name));
        return file.Exists ? file : null;
    }

    private static async Task<Measurements> FirstFrameAsync(FileInfo program, string way)
    {
        using Peer sender = await Peer.StartAsync("pace", "--connections", "1", "--rate", "1000", "--seconds", "0.2");
        (long start, Process process) = Run(program.FullName, way, Peer.Text(sender.Port));
        using (process)
        {
            string line = await process.StandardOutput.ReadToEndAsync();
            await process.WaitForExitAsync();
            return new Measurements { [Figure] = (long.Parse(line, CultureInfo.InvariantCulture) - start) * 1000.0 / Stopwatch.Frequency };
        }
    }

    // script gives the program a terminal, and passes on what it writes there.
    private static async Task<Measurements> FirstPictureAsync(FileInfo program)
    {
        (long start, Process process) = Run("script", "-qefc", $"stty cols 120 rows 40; {program.FullName} watch demo --duration 3", "/dev/null");
        using (process)
        {
            string shown = string.Empty;
            char[] buffer = new char[4096];

            // The names of bones appear with the first frame.
            while (!shown.Contains("Hips", StringComparison.Ordinal))
            {
                int count = await process.StandardOutput.ReadAsync(buffer);
                if (count == 0)
                    throw new InvalidOperationException("The program ended without a picture.");

                shown += new string(buffer, 0, count);
            }

            var figures = new Measurements { [Figure] = Stopwatch.GetElapsedTime(start).TotalMilliseconds };
            await process.StandardOutput.ReadToEndAsync();
            await process.WaitForExitAsync();
            return figures;
        }
    }

    private async Task<Measurements> VersionAsync(string folder)
    {
        (long start, Process process) = Run(Find(folder, "neuron-mocap")!.FullName, "--version");
        using (process)
        {
            await process.StandardOutput.ReadToEndAsync();
            await process.WaitForExitAsync();
            return new Measurements { [Figure] = Stopwatch.GetElapsedTime(start).TotalMilliseconds };
        }
    }

    private static (long Start, Process Process) Run(string program, params string[] arguments)
    {
        var start = new ProcessStartInfo(program, arguments) { RedirectStandardOutput = true, UseShellExecute = false };
        start.RedirectStandardInput = true;
        start.Environment["TERM"] = "xterm-256color";
        long now = Stopwatch.GetTimestamp();
        return (now, Process.Start(start) ?? throw new InvalidOperationException("The program did not start."));
    }
}
