using System.Text;
using Spectre.Console;
using Spectre.Console.Rendering;

namespace NeuronMocap.Tool.Terminal;

/// <summary>
/// The terminal's alternate screen. A frame is drawn into memory and only the lines that changed are sent, in one write: nothing flickers.
/// Disposing of it brings the terminal back as it was.
/// </summary>
internal sealed class Screen : IDisposable
{
    private const string Enter = "\e[?1049h";
    private const string Leave = "\e[?7h\e[?25h\e[?1049l";

    // No cursor, no wrapping at the edge, nothing on the screen.
    private const string Clear = "\e[?25l\e[?7l\e[2J";

    // Terminals that know these show what is between them at once; the others pass over them.
    private const string BeginUpdate = "\e[?2026h";
    private const string EndUpdate = "\e[?2026l";

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

    /// <summary>Whether the terminal can show the view at all.</summary>
    public static bool IsSupported => AnsiConsole.Profile.Capabilities.Ansi;

    public static int Width => Math.Max(Console.WindowWidth, 1);

    public static int Height => Math.Max(Console.WindowHeight, 1);

    /// <summary>Has the next picture drawn as a whole, because somebody else wrote to the terminal. Any thread.</summary>
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
            // The terminal is gone; the signal that says so ends the program.
        }
    }

    // Every line covers what was there before: erasing first would show for a moment.
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
