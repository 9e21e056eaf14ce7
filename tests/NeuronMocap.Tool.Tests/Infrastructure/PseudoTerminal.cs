using System.Diagnostics;
using System.Text;

namespace NeuronMocap.Tool.Tests.Infrastructure;

/// <summary>The program in a terminal of 80 x 24, created by the program "script" of util-linux.</summary>
internal sealed class PseudoTerminal : IDisposable
{
    private static readonly TimeSpan Limit = TimeSpan.FromMinutes(2);

    private readonly Process _process;
    private readonly StringBuilder _text = new();
    private readonly SemaphoreSlim _arrived = new(0);
    private readonly Task _reading;

    public PseudoTerminal(string folder, string environment, params string[] args)
    {
        string dotnet = Environment.GetEnvironmentVariable("DOTNET_HOST_PATH") ?? "dotnet";
        string command = $"stty cols 80 rows 24; cd '{folder}'; exec env {environment} '{dotnet}' '{ToolProcess.PathOf("neuron-mocap")}' {string.Join(' ', args)}";
        _process = Process.Start(new ProcessStartInfo("script", ["-q", "-e", "-c", command, "/dev/null"])
        {
            UseShellExecute = false,
            RedirectStandardInput = true,
            RedirectStandardOutput = true,
        })!;
        _reading = ReadAsync();
    }

    /// <summary>Whether the program that creates a terminal exists.</summary>
    public static bool IsSupported => OperatingSystem.IsLinux() && File.Exists("/usr/bin/script");

    /// <summary>All output to the terminal.</summary>
    public string Text
    {
        get
        {
            lock (_text)
                return _text.ToString();
        }
    }

    public void Press(string keys)
    {
        _process.StandardInput.Write(keys);
        _process.StandardInput.Flush();
    }

    /// <summary>Waits until this text was written to the terminal.</summary>
    public async Task WaitForAsync(string text)
    {
        long start = Stopwatch.GetTimestamp();
        while (!Text.Contains(text, StringComparison.Ordinal))
        {
            Assert.False(_reading.IsCompleted, $"The program ended without '{text}': {Text}");
            Assert.True(Stopwatch.GetElapsedTime(start) < Limit, $"'{text}' did not come: {Text}");
            await _arrived.WaitAsync(Limit, TestContext.Current.CancellationToken);
        }
    }

    public async Task<int> WaitForExitAsync()
    {
        await _process.WaitForExitAsync(TestContext.Current.CancellationToken).WaitAsync(Limit, TestContext.Current.CancellationToken);
        await _reading.WaitAsync(Limit, TestContext.Current.CancellationToken);
        return _process.ExitCode;
    }

    public void Dispose()
    {
        if (!_process.HasExited)
            _process.Kill(entireProcessTree: true);

        _process.Dispose();
        _arrived.Dispose();
    }

    private async Task ReadAsync()
    {
        char[] buffer = new char[4096];
        int length;
        while ((length = await _process.StandardOutput.ReadAsync(buffer)) > 0)
        {
            lock (_text)
                _text.Append(buffer, 0, length);

            _arrived.Release();
        }

        _arrived.Release();
    }
}
