using System.Diagnostics;
using System.Globalization;

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
        var start = new ProcessStartInfo("dotnet") { RedirectStandardOutput = true, UseShellExecute = false };
        start.ArgumentList.Add("exec");
        start.ArgumentList.Add(typeof(Peer).Assembly.Location);
        foreach (string argument in arguments)
            start.ArgumentList.Add(argument);

        Process process = Process.Start(start) ?? throw new InvalidOperationException("The peer did not start.");
        string port = await process.StandardOutput.ReadLineAsync() ?? throw new InvalidOperationException("The peer has no port.");
        return new Peer(process, int.Parse(port, CultureInfo.InvariantCulture));
    }

    public async Task<string> ReadLineAsync() => await _process.StandardOutput.ReadLineAsync() ?? throw new InvalidOperationException("The peer ended.");

    public void Dispose()
    {
        _process.WaitForExit();
        _process.Dispose();
    }

    public static string Text(double value) => value.ToString(CultureInfo.InvariantCulture);
}
