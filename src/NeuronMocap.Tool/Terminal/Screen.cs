using System.Text;
using Spectre.Console;
using Spectre.Console.Rendering;

namespace NeuronMocap.Tool.Terminal;

/// <summary>The terminal's alternate screen.</summary>
/// <remarks>
/// It draws into memory and sends only the changed lines, in one write, so that nothing flickers. Disposing it restores the terminal.
/// </remarks>
internal sealed class Screen : IDisposable
{
    private const string Enter = "\e[?1049h";

    // A terminal without an alternate screen keeps everything that is not erased.
    private const string Leave = "\e[?7h\e[?25h\e[2J\e[H\e[?1049l";

    // Hides the cursor, switches off wrapping at the edge, and clears the screen.
    private const string Clear = "\e[?25l\e[?7l\e[2J";

    // A terminal that knows these sequences shows the text between them at once. Others ignore them.
    private const string BeginUpdate = "\e[?2026h";
    private const string EndUpdate = "\e[?2026l";

    private const int UsualWidth = 80;
    private const int UsualHeight = 24;

    private readonly Stream _output;
    private readonly StringWriter _drawing = new();
    private readonly IAnsiConsole _console;
    private string[] _shown = [];
    private int _width;
    private int _height;
    private volatile bool _isStale;

    public Screen(Stream output)
    {
        _output = output;
        _console = AnsiConsole.Create(new AnsiConsoleSettings
        {
            Ansi = AnsiSupport.Yes,
            Interactive = InteractionSupport.No,
            Out = new AnsiConsoleOutput(_drawing),
        });
        _console.Profile.Capabilities.ColorSystem = AnsiConsole.Profile.Capabilities.ColorSystem;
        _console.Profile.Capabilities.Unicode = true;
        Send(Enter);
    }

    /// <summary>Whether the terminal can move the cursor, which the view needs.</summary>
    public static bool IsSupported => CanMoveCursor(Console.Out);

    /// <summary>Columns of the window. Some terminals do not know their size and report 0.</summary>
    public static int Width => Console.WindowWidth is > 0 and var width ? width : UsualWidth;

    /// <summary>Lines of the window.</summary>
    public static int Height => Console.WindowHeight is > 0 and var height ? height : UsualHeight;

    /// <summary>Whether a terminal knows the sequences that move its cursor. On Windows, this also switches them on.</summary>
    public static bool CanMoveCursor(TextWriter terminal) => !string.Equals(Environment.GetEnvironmentVariable("TERM"), "dumb", StringComparison.Ordinal)
        && AnsiConsole.Create(new AnsiConsoleSettings { Out = new AnsiConsoleOutput(terminal) }).Profile.Capabilities.Ansi;

    /// <summary>Makes the next picture complete, because another program wrote to the terminal. Thread-safe.</summary>
    public void Invalidate() => _isStale = true;

    public void Show(IRenderable view, int width, int height)
    {
        var update = new StringBuilder(BeginUpdate);
        if (width != _width || height != _height || _isStale)
        {
            _isStale = false;
            (_width, _height) = (width, height);
            _shown = new string[height];
            update.Append(Clear);
        }

        string[] lines = Draw(view);
        for (int row = 0; row < height; row++)
        {
            string line = row < lines.Length - 1 ? lines[row] : new string(' ', width);
            if (string.Equals(line, _shown[row], StringComparison.Ordinal))
                continue;

            update.Append(null, $"\e[{row + 1};1H{line}");
            _shown[row] = line;
        }

        Send(update.Append(EndUpdate).ToString());
    }

    public void Dispose()
    {
        Send(Leave);
        _drawing.Dispose();
    }

    private string[] Draw(IRenderable view)
    {
        _console.Profile.Width = _width;
        _console.Profile.Height = _height;
        _drawing.GetStringBuilder().Clear();
        _console.Write(new FullLines(view));
        return _drawing.ToString().Split('\n');
    }

    private void Send(string text)
    {
        try
        {
            _output.Write(Encoding.UTF8.GetBytes(text));
            _output.Flush();
        }
        catch (IOException)
        {
            // The terminal was closed. The system sends a signal, which ends the program.
        }
    }

    // Each line covers the old one, because erasing first would flicker.
    private sealed class FullLines(IRenderable view) : Renderable
    {
        protected override IEnumerable<Segment> Render(RenderOptions options, int maxWidth)
        {
            foreach (SegmentLine line in Segment.SplitLines(view.Render(options, maxWidth), maxWidth))
            {
                line.Add(Segment.Padding(Math.Max(maxWidth - line.CellCount(), 0)));
                foreach (Segment segment in line)
                    yield return segment;

                yield return Segment.LineBreak;
            }
        }
    }
}
