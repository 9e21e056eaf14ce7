using Microsoft.Win32.SafeHandles;

namespace NeuronMocap.Tool.Terminal;

/// <summary>Where the program writes to; tests put memory in its place.</summary>
/// <param name="Output">Standard output; it throws an <see cref="IOException"/> when nobody reads it any more.</param>
/// <param name="Error">Standard error.</param>
/// <param name="IsTerminal">Whether a person looks at the output.</param>
internal sealed record StandardStreams(Stream Output, TextWriter Error, bool IsTerminal) : IDisposable
{
    // Unwrapped where no person looks: a program that searches the text finds every phrase in one line.
    private const int Unlimited = 100_000;

    // Some terminals do not know their size, and say 0; Spectre.Console does not come to an end with less than a table's columns take.
    private const int NarrowestText = 40;

    private const int StandardOutput = 1;

    /// <summary>Whether a person looks at standard error, in a terminal that can move its cursor.</summary>
    public bool IsErrorTerminal { get; init; }

    /// <summary>Characters in a line of the terminal, as it says itself.</summary>
    public int Columns { get; init; }

    public static StandardStreams Open() => new(OpenOutput(), Console.Error, IsTerminal: !Console.IsOutputRedirected)
    {
        IsErrorTerminal = !Console.IsErrorRedirected && Screen.CanMoveCursor(Console.Error),
        Columns = Console.IsOutputRedirected ? 0 : Screen.Width,
    };

    /// <summary>How wide lines of text become.</summary>
    /// <param name="widest">Longer lines are hard to read.</param>
    public int TextWidth(int widest) => IsTerminal ? Math.Clamp(Columns, NarrowestText, widest) : Unlimited;

    /// <summary>Writes one line to standard error. Every line there begins with the name of the program.</summary>
    /// <param name="message">A sentence; what a terminal would obey is replaced.</param>
    public void Complain(string message) => Error.WriteLine(LineOf(message));

    /// <inheritdoc cref="Complain"/>
    public Task ComplainAsync(string message) => Error.WriteLineAsync(LineOf(message));

    public void Dispose() => Output.Dispose();

    private static string LineOf(string message) => $"{CommandLine.Name}: {TerminalText.Clean(message)}";

    // The console's own stream passes over a broken pipe in silence, so that `neuron-mocap watch --json | head -1` would never end; a FileStream
    // throws. A regular file cannot break, and a FileStream would not move the position that the shell shares with the next program.
    private static Stream OpenOutput()
    {
        if (OperatingSystem.IsWindows() || !Console.IsOutputRedirected)
            return Console.OpenStandardOutput();

        var stream = new FileStream(new SafeFileHandle(StandardOutput, ownsHandle: false), FileAccess.Write, bufferSize: 0);
        return stream.CanSeek ? Console.OpenStandardOutput() : stream;
    }
}
