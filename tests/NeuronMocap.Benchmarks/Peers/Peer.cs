using System.Diagnostics;
using System.Globalization;
using NeuronMocap.Benchmarks.Harness;

namespace NeuronMocap.Benchmarks.Peers;

// The other end of the wire in its own process: this program with one of its hidden commands, which first prints its port.
internal sealed class Peer : IDisposable
{
    private readonly Process _process;

    private Peer(Process process, int port)
    {
        _process = process;
        Port = port;
    }

    public int Port { get; }

    public static async Task<Peer> StartAsync(params string[] arguments)
    {
        string program = $"\"{typeof(Peer).Assembly.Location}\" {string.Join(" ", arguments)}";
        ProcessStartInfo start = RuntimeFigures.IsMono ? new("mono", program) : new("dotnet", $"exec {program}");
        start.RedirectStandardOutput = true;
        start.RedirectStandardInput = true;
        start.UseShellExecute = false;
        Process process = Process.Start(start) ?? throw new InvalidOperationException("The peer did not start.");
        string port = await process.StandardOutput.ReadLineAsync() ?? throw new InvalidOperationException("The peer has no port.");
        return new Peer(process, int.Parse(port, CultureInfo.InvariantCulture));
    }

    public async Task<string> ReadLineAsync() => await _process.StandardOutput.ReadLineAsync() ?? throw new InvalidOperationException("The peer ended.");

    // Tells a peer that runs until then to end.
    public void CloseInput() => _process.StandardInput.Close();

    public void Dispose()
    {
        CloseInput();
        _process.WaitForExit();
        _process.Dispose();
    }

    public static string Text(double value) => value.ToString(CultureInfo.InvariantCulture);
}
