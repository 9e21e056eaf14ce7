using System.Diagnostics;
using Repository = NeuronMocap.Tests.Infrastructure.Repository;

namespace NeuronMocap.Tool.Tests.Infrastructure;

/// <summary>Runs one of the programs as its own process, as a shell does.</summary>
internal sealed class ToolProcess : IDisposable
{
    private static readonly TimeSpan Limit = TimeSpan.FromSeconds(60);

    private readonly Process _process;

    public ToolProcess(string program, params string[] args)
        : this(environment: null, program, args)
    {
    }

    public ToolProcess((string Name, string Value)? environment, string program, string[] args)
    {
        var start = new ProcessStartInfo(Environment.GetEnvironmentVariable("DOTNET_HOST_PATH") ?? "dotnet")
        {
            UseShellExecute = false,
            RedirectStandardInput = true,
            RedirectStandardOutput = true,
            RedirectStandardError = true,
        };
        string[] words = program.Split(' ');
        foreach (string argument in (string[])[PathOf(words[0]), .. words[1..], .. args])
            start.ArgumentList.Add(argument);

        if (environment is var (name, value))
            start.Environment[name] = value;

        _process = Process.Start(start)!;
    }

    public StreamReader Output => _process.StandardOutput;

    public int Id => _process.Id;

    // The built program in its own folder. The tests' folder lacks frameworks that the program needs, and may hold a copy of the program.
    public static string PathOf(string program)
    {
        var output = new DirectoryInfo(AppContext.BaseDirectory);
        return Directory.GetDirectories(Repository.PathOf("src"))
            .Concat(Directory.GetDirectories(Repository.PathOf("samples")))
            .Concat(Directory.GetDirectories(Repository.PathOf("tests")))
            .Where(folder => !output.FullName.StartsWith(folder, StringComparison.Ordinal))
            .Select(sample => Path.Combine(sample, "bin", output.Parent!.Name, output.Name, program + ".dll"))
            .First(File.Exists);
    }

    // A shell that runs the tests in the background disables SIGINT. SIGINT is number 2, bit 1 of the mask of ignored signals.
    public static bool IgnoresInterrupt()
    {
        string? line = File.Exists("/proc/self/status")
            ? File.ReadLines("/proc/self/status").FirstOrDefault(static entry => entry.StartsWith("SigIgn:", StringComparison.Ordinal))
            : null;
        return line is not null && (System.Convert.ToUInt64(line["SigIgn:".Length..].Trim(), 16) & 2) != 0;
    }

    public static void SkipWithoutInterrupt()
    {
        if (OperatingSystem.IsWindows())
            Assert.Skip("There are no signals to send.");
        if (IgnoresInterrupt())
            Assert.Skip("The shell that runs the tests in the background has switched SIGINT off, and programs inherit that.");
    }

    /// <summary>Sends SIGINT, as Ctrl+C does.</summary>
    public void Interrupt() => Signals.Send("INT", Id);

    public async Task<int> WaitForExitAsync()
    {
        await _process.WaitForExitAsync(TestContext.Current.CancellationToken).WaitAsync(Limit, TestContext.Current.CancellationToken);
        return _process.ExitCode;
    }

    // At once, without notice to the process: SIGKILL.
    public void Kill()
    {
        _process.Kill();
        _process.WaitForExit(Limit);
    }

    public Task<string> ReadErrorAsync() => _process.StandardError.ReadToEndAsync(TestContext.Current.CancellationToken);

    public void Dispose()
    {
        if (!_process.HasExited)
            _process.Kill();

        _process.Dispose();
    }
}
