using System.Diagnostics;

namespace NeuronMocap.Tests.RabbitMq;

/// <summary>A program that ends with this process, also if a debugger, a time limit or Ctrl+C ends the tests.</summary>
internal sealed class ChildProcess : IDisposable
{
    // The guard ends the program when the pipe to this process closes. The shell ends when the program does. What a shell runs with '&' ignores Ctrl+C.
    private const string Script = """
        exec 3<&0 4> "$0" > /dev/null 2>&1
        "$@" >&4 2>&4 3<&- &
        program=$!
        { cat <&3; kill -9 $program; } 4>&- &
        guard=$!
        wait $program
        kill -9 $guard
        """;

    private static readonly TimeSpan EndLimit = TimeSpan.FromMinutes(1);

    private readonly Process _process;

    private ChildProcess(Process process) => _process = process;

    /// <summary>Whether the program has ended by itself.</summary>
    public bool HasExited => _process.HasExited;

    /// <param name="log">The file for the output.</param>
    /// <param name="environment">Variables to set.</param>
    /// <param name="command">The program and its arguments.</param>
    public static ChildProcess Start(string log, IReadOnlyDictionary<string, string> environment, params IEnumerable<string> command)
    {
        var start = new ProcessStartInfo("/bin/sh", ["-c", Script, log, .. command]) { UseShellExecute = false, RedirectStandardInput = true };
        foreach ((string name, string value) in environment)
            start.Environment[name] = value;

        return new ChildProcess(Process.Start(start)!);
    }

    /// <summary>Ends the program at once, as a power failure does.</summary>
    public void Dispose()
    {
        _process.StandardInput.Close();
        if (!_process.WaitForExit(EndLimit))
            _process.Kill(entireProcessTree: true);

        _process.Dispose();
    }
}
