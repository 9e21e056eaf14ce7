using System.Text;
using Spectre.Console;

namespace NeuronMocap.Tool.Terminal;

/// <summary>
/// Readable text: in colours and wrapped on a terminal, otherwise plain and unwrapped. A search then finds every phrase in one line.
/// </summary>
internal sealed class TextPage
{
    private const int Indent = 2;

    private readonly bool _isTerminal;

    /// <summary>Creates a page on standard output.</summary>
    /// <param name="streams">The streams. Writing throws an <see cref="IOException"/> if it fails.</param>
    /// <param name="widest">Maximum width, because longer lines are hard to read.</param>
    public TextPage(StandardStreams streams, int widest)
    {
        _isTerminal = streams.IsTerminal;
        Width = streams.TextWidth(widest);
        Console = AnsiConsole.Create(new AnsiConsoleSettings
        {
            Ansi = _isTerminal && Screen.IsSupported ? AnsiSupport.Yes : AnsiSupport.No,
            Interactive = InteractionSupport.No,
            Out = new AnsiConsoleOutput(new StreamWriter(streams.Output, new UTF8Encoding(encoderShouldEmitUTF8Identifier: false), leaveOpen: true) { AutoFlush = true }),
        });
        Console.Profile.Capabilities.ColorSystem = _isTerminal ? AnsiConsole.Profile.Capabilities.ColorSystem : ColorSystem.NoColors;
        Console.Profile.Width = Width;
    }

    /// <summary>The console of the page.</summary>
    public IAnsiConsole Console { get; }

    /// <summary>Characters in a line.</summary>
    public int Width { get; }

    public void WriteLine() => Console.WriteLine();

    public void WriteLine(string text, Style? style = null)
    {
        Console.Write(new Text(TerminalText.Clean(text), style));
        Console.WriteLine();
    }

    /// <summary>Writes a line that the terminal wraps itself. A link in it can be clicked and copied.</summary>
    public void WriteUnbroken(string text) => Console.Profile.Out.Writer.WriteLine(TerminalText.Clean(text));

    /// <summary>Writes a label, and beside it a text of one or more lines. Without a label, the text is indented.</summary>
    /// <param name="label">The label.</param>
    /// <param name="width">Width of the label's column; 0 for none.</param>
    /// <param name="text">The text.</param>
    /// <param name="labelStyle">Style of the label; dim by default.</param>
    public void WriteRow(string label, int width, string text, Style? labelStyle = null)
    {
        (label, string clean) = (TerminalText.Clean(label), TerminalText.Clean(text));
        if (!_isTerminal)
        {
            // A grid pads its lines to full width.
            Console.WriteLine(width == 0 ? $"  {clean}" : $"  {label.PadRight(width)}  {clean}");
            return;
        }

        var grid = new Grid();
        if (width > 0)
            grid.AddColumn(new GridColumn { Width = width, Padding = new Padding(Indent, 0, Indent, 0), NoWrap = true });

        grid.AddColumn(new GridColumn { Padding = new Padding(width > 0 ? 0 : Indent, 0, 0, 0) });
        Console.Write(width > 0 ? grid.AddRow(new Text(label, labelStyle ?? Palette.DimStyle), new Text(clean)) : grid.AddRow(new Text(clean)));
    }
}
