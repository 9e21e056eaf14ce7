using System.Diagnostics;
using System.Globalization;

namespace NeuronMocap.Benchmarks.Peers;

// A receiver of tests/native/bench, the library's or the floor, or ManagedReceiver. It prints figures as name and number, or only delays.
internal sealed class NativeReceiver : IDisposable
{
    private readonly Process _process;

    private NativeReceiver(Process process) => _process = process;

    public static NativeReceiver Start(FileInfo program, string mode, int port, long frames) => Start(program.FullName, [mode, Peer.Text(port), Peer.Text(frames)]);

    public static NativeReceiver Start(string program, params string[] arguments)
    {
        var start = new ProcessStartInfo(program, arguments) { RedirectStandardOutput = true, UseShellExecute = false };
        return new NativeReceiver(Process.Start(start) ?? throw new InvalidOperationException("The receiver did not start."));
    }

    public async Task WaitUntilReadyAsync()
    {
        if (await _process.StandardOutput.ReadLineAsync() != "ready")
            throw new InvalidOperationException("The receiver is not ready.");
    }

    public async Task<Dictionary<string, ulong>> ReadFiguresAsync()
    {
        string[][] lines = [.. (await ReadLinesAsync()).Select(static line => line.Split(' '))];
        return lines.ToDictionary(static words => words[0], static words => ulong.Parse(words[1], CultureInfo.InvariantCulture));
    }

    public async Task<string[]> ReadLinesAsync()
    {
        string output = await _process.StandardOutput.ReadToEndAsync();
        await _process.WaitForExitAsync();
        return _process.ExitCode == 0
            ? output.Split('\n', StringSplitOptions.RemoveEmptyEntries)
            : throw new InvalidOperationException($"The receiver ended with {_process.ExitCode}.");
    }

    public void Dispose() => _process.Dispose();
}
