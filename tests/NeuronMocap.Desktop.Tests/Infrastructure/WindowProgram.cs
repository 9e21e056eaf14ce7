using System.Diagnostics;
using System.Text;
using System.Text.RegularExpressions;

namespace NeuronMocap.Desktop.Tests.Infrastructure;

/// <summary>
/// A program of .NET Framework with one window, run by Mono on a screen. Each control of Mono's Windows Forms is a window of the screen, whose name is
/// the control's text.
/// </summary>
internal sealed class WindowProgram : IDisposable
{
    // Mono's Windows Forms writes it now and then, about input methods.
    private const string Ignored = "Could not set X locale modifiers";

    private static readonly TimeSpan Poll = TimeSpan.FromMilliseconds(50);

    private readonly Screen _screen;
    private readonly Process _process;
    private readonly StringBuilder _output = new();
    private readonly string _title;

    private WindowProgram(Screen screen, string title, string[] arguments)
    {
        _screen = screen;
        _title = title;
        _process = screen.Launch("mono", ["--debug", .. arguments]);
        _process.OutputDataReceived += Keep;
        _process.ErrorDataReceived += Keep;
        _process.BeginOutputReadLine();
        _process.BeginErrorReadLine();
    }

    /// <summary>What the program has written, without empty lines.</summary>
    public string Output
    {
        get
        {
            lock (_output)
                return _output.ToString();
        }
    }

    /// <summary>Starts a program, waits for its window, and gives it the keyboard.</summary>
    public static async Task<WindowProgram> StartAsync(Screen screen, string title, params string[] arguments)
    {
        var program = new WindowProgram(screen, title, arguments);
        try
        {
            await program.FocusAsync();
            return program;
        }
        catch
        {
            program.Dispose();
            throw;
        }
    }

    /// <summary>Waits until a control has a text that matches.</summary>
    /// <returns>The match.</returns>
    public async Task<Match> UntilTextAsync(string pattern)
    {
        string texts = "";
        Match? match = null;
        await UntilAsync(
            async () =>
            {
                texts = await RunAsync("search", "--onlyvisible", "--name", ".", "getwindowname", "%@") ?? texts;
                match = Regex.Match(texts, pattern, RegexOptions.Multiline | RegexOptions.CultureInvariant, Limits.Unexpected);
                return match.Success;
            },
            () => $"No control says '{pattern}'. They say:\n{texts}");
        return match!;
    }

    /// <summary>Clicks the control with this text.</summary>
    public Task ClickAsync(string text) => UntilAsync(
        async () => await RunAsync("search", "--onlyvisible", "--name", $"^{text}$", "mousemove", "--window", "%1", "20", "10", "click", "1") is not null,
        () => $"There is no '{text}' to click.");

    /// <summary>Types a text and presses Enter.</summary>
    public async Task EnterAsync(string text)
    {
        Assert.NotNull(await RunAsync("type", "--delay", "5", text));
        Assert.NotNull(await RunAsync("key", "Return"));
    }

    /// <summary>Takes a picture of the control with this text.</summary>
    public async Task<Picture> TakePictureAsync(string text)
    {
        string? window = await RunAsync("search", "--onlyvisible", "--name", $"^{text}$");
        Assert.NotNull(window);
        byte[]? file = await _screen.RunAsync("import", "-silent", "-window", window.Trim(), "-depth", "8", "ppm:-");
        Assert.NotNull(file);
        return Picture.FromPpm(file);
    }

    /// <summary>Waits for a picture of the control with this text.</summary>
    public async Task<Picture> UntilPictureAsync(string text, Func<Picture, bool> condition)
    {
        Picture? picture = null;
        await UntilAsync(
            async () =>
            {
                picture = await TakePictureAsync(text);
                return condition(picture);
            },
            () => $"The picture of '{text}' does not become what it should.");
        return picture!;
    }

    /// <summary>Closes the window with Alt+F4.</summary>
    /// <param name="allowsFailureOfMono">Whether <see cref="HasMonoFailed"/> is accepted beside exit code 0.</param>
    /// <returns>The time from the key to the end of the process.</returns>
    public async Task<TimeSpan> CloseAsync(bool allowsFailureOfMono = false)
    {
        long start = Stopwatch.GetTimestamp();
        Assert.NotNull(await RunAsync("key", "alt+F4"));
        await _process.WaitForExitAsync(TestContext.Current.CancellationToken).Soon();
        TimeSpan time = Stopwatch.GetElapsedTime(start);
        Assert.True(_process.ExitCode == 0 || (allowsFailureOfMono && HasMonoFailed), $"The program ended with {_process.ExitCode}: {Output}");
        return time;
    }

    /// <summary>
    /// Whether Mono failed at the end of the process, after the program: it aborts the thread of its own timers, which does not expect that.
    /// </summary>
    public bool HasMonoFailed =>
        Output.Contains("ThreadAbortException", StringComparison.Ordinal) && Output.Contains("System.Threading.Timer+Scheduler.SchedulerThread", StringComparison.Ordinal);

    public void Dispose()
    {
        if (!_process.HasExited)
            _process.Kill();

        _process.WaitForExit();
        _process.Dispose();
    }

    private Task FocusAsync() => UntilAsync(
        async () => await RunAsync("search", "--onlyvisible", "--name", $"^{_title}$", "windowactivate", "--sync") is not null,
        () => $"There is no window '{_title}'.");

    private async Task UntilAsync(Func<Task<bool>> condition, Func<string> fault)
    {
        long start = Stopwatch.GetTimestamp();
        while (!await condition())
        {
            Assert.False(_process.HasExited, $"The program has ended: {Output}");
            Assert.True(Stopwatch.GetElapsedTime(start) < Limits.Unexpected, $"{fault()}\nIt has written: {Output}");
            await Task.Delay(Poll, TestContext.Current.CancellationToken);
        }
    }

    private async Task<string?> RunAsync(params string[] arguments) =>
        await _screen.RunAsync("xdotool", arguments) is { } output ? Encoding.UTF8.GetString(output) : null;

    private void Keep(object sender, DataReceivedEventArgs line)
    {
        if (string.IsNullOrWhiteSpace(line.Data) || line.Data == Ignored)
            return;

        lock (_output)
            _output.AppendLine(line.Data);
    }
}
