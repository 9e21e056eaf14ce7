using System.Diagnostics;

namespace NeuronMocap.Desktop.Tests.Infrastructure;

/// <summary>A virtual screen with a window manager, which closes a window with Alt+F4. Its programs have a home folder of their own.</summary>
internal sealed class Screen : IDisposable
{
    private const string Forms = "/usr/lib/mono/4.5/System.Windows.Forms.dll";
    private static readonly string[] Tools = ["Xvfb", "jwm", "xdotool", "import", "mono"];

    private readonly string _home = Directory.CreateTempSubdirectory("neuron-mocap-home-").FullName;
    private readonly string _display;
    private readonly Process _server;
    private readonly Process _manager;

    private Screen(Process server, string display)
    {
        _server = server;
        _display = display;
        _manager = Launch("jwm", "-f", Path.Combine(AppContext.BaseDirectory, "Infrastructure", "jwm.xml"));
    }

    public static void Require()
    {
        Assert.SkipUnless(
            OperatingSystem.IsLinux() && Tools.All(InstalledPrograms.Have) && File.Exists(Forms),
            "Needs Linux and Debian's packages xvfb, jwm, xdotool, imagemagick and libmono-system-windows-forms4.0-cil.");
    }

    // The server chooses a free display, and prints its number when it is ready.
    public static async Task<Screen> OpenAsync()
    {
        Process server = Process.Start(Describe("Xvfb", "-displayfd", "1", "-screen", "0", "1200x800x24", "-nolisten", "tcp", "-noreset"))!;
        server.ErrorDataReceived += static (_, _) => { };
        server.BeginErrorReadLine();
        string? number = await server.StandardOutput.ReadLineAsync(TestContext.Current.CancellationToken).AsTask().Soon();
        Assert.NotNull(number);
        return new Screen(server, ":" + number);
    }

    /// <summary>Starts a program on this screen.</summary>
    public Process Launch(string program, params string[] arguments)
    {
        ProcessStartInfo start = Describe(program, arguments);
        start.Environment["DISPLAY"] = _display;
        start.Environment["HOME"] = _home;
        Process process = Process.Start(start)!;
        process.StandardInput.Close();
        return process;
    }

    /// <summary>Runs a program on this screen to its end.</summary>
    /// <returns>What it writes; null if it fails, for example because a window has disappeared.</returns>
    public async Task<byte[]?> RunAsync(string program, params string[] arguments)
    {
        using Process process = Launch(program, arguments);
        process.ErrorDataReceived += static (_, _) => { };
        process.BeginErrorReadLine();
        using var output = new MemoryStream();
        await process.StandardOutput.BaseStream.CopyToAsync(output, TestContext.Current.CancellationToken).Soon();
        await process.WaitForExitAsync(TestContext.Current.CancellationToken).Soon();
        return process.ExitCode == 0 ? output.ToArray() : null;
    }

    public void Dispose()
    {
        foreach (Process process in (Process[])[_manager, _server])
        {
            process.Kill();
            process.WaitForExit();
            process.Dispose();
        }

        Directory.Delete(_home, recursive: true);
    }

    private static ProcessStartInfo Describe(string program, params string[] arguments) => new(program, arguments)
    {
        Environment = { ["LC_ALL"] = "C" },
        UseShellExecute = false,
        RedirectStandardInput = true,
        RedirectStandardOutput = true,
        RedirectStandardError = true,
    };
}
