using Microsoft.Win32.SafeHandles;

namespace NeuronMocap.Tool.Terminal;

/// <summary>The streams that the program writes to. Tests replace them by memory.</summary>
/// <param name="Output">Standard output. It throws an <see cref="IOException"/> when its reader has closed it.</param>
/// <param name="Error">Standard error.</param>
/// <param name="IsTerminal">Whether the output is a terminal.</param>
internal sealed record StandardStreams(Stream Output, TextWriter Error, bool IsTerminal) : IDisposable
{
    // Text outside a terminal is not wrapped, so that a search finds every phrase in one line.
    private const int Unlimited = 100_000;

    // Some terminals do not know their size and report 0. Spectre.Console loops forever if the width is less than the columns of a table need.
    private const int NarrowestText = 40;

    private const int StandardOutput = 1;

    /// <summary>Whether standard error is a terminal that can move its cursor.</summary>
    public bool IsErrorTerminal { get; init; }

    /// <summary>Characters in a line, as the terminal reports them.</summary>
    public int Columns { get; init; }

    public static StandardStreams Open() => new(OpenOutput(), new UnfailingWriter(Console.Error), IsTerminal: !Console.IsOutputRedirected)
    {
        IsErrorTerminal = !Console.IsErrorRedirected && Screen.CanMoveCursor(Console.Error),
        Columns = Console.IsOutputRedirected ? 0 : Screen.Width,
    };

    /// <summary>Gets the width of lines of text.</summary>
    /// <param name="widest">Maximum width, because longer lines are hard to read.</param>
    public int TextWidth(int widest) => IsTerminal ? Math.Clamp(Columns, NarrowestText, widest) : Unlimited;

    /// <summary>Writes one line to standard error. Every such line starts with the name of the program.</summary>
    /// <param name="message">A sentence. Control characters for a terminal are replaced.</param>
    public void Complain(string message) => Error.WriteLine(LineOf(message));

    /// <inheritdoc cref="Complain"/>
    public Task ComplainAsync(string message) => Error.WriteLineAsync(LineOf(message));

    /// <summary>Whether the output could not be written because its reader closed it.</summary>
    public static bool IsBrokenPipe(IOException exception)
    {
        const int BrokenPipe = 32;
        return exception.HResult == BrokenPipe;
    }

    public void Dispose() => Output.Dispose();

    private static string LineOf(string message) => $"{ToolCommand.Name}: {TerminalText.Clean(message)}";

    // The console's own stream silently ignores a broken pipe, so `neuron-mocap watch --json | head -1` would never end. A FileStream throws. A
    // regular file cannot break, and a FileStream would not move the position that the shell shares with the next program.
    private static Stream OpenOutput()
    {
        if (OperatingSystem.IsWindows() || !Console.IsOutputRedirected)
            return Console.OpenStandardOutput();

        var stream = new FileStream(new SafeFileHandle(StandardOutput, ownsHandle: false), FileAccess.Write, bufferSize: 0);
        return stream.CanSeek ? Console.OpenStandardOutput() : stream;
    }
}
