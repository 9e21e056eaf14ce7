using System.Text;
using NeuronMocap.Tool.Terminal;
using Spectre.Console;

namespace NeuronMocap.Tool.Info;

/// <summary>A report for a person: with headings in bold and wrapped on a terminal, plain and unwrapped elsewhere.</summary>
internal sealed class InfoPage
{
    private const int WidestText = 110;
    private const int MostItems = 20;

    private readonly IAnsiConsole _console;
    private readonly bool _isTerminal;

    public InfoPage(StandardStreams streams)
    {
        _isTerminal = streams.IsTerminal;
        _console = AnsiConsole.Create(new AnsiConsoleSettings
        {
            Ansi = _isTerminal && Screen.IsSupported ? AnsiSupport.Yes : AnsiSupport.No,
            Interactive = InteractionSupport.No,
            Out = new AnsiConsoleOutput(new StreamWriter(streams.Output, new UTF8Encoding(encoderShouldEmitUTF8Identifier: false)) { AutoFlush = true }),
        });
        _console.Profile.Capabilities.ColorSystem = _isTerminal ? AnsiConsole.Profile.Capabilities.ColorSystem : ColorSystem.NoColors;
        _console.Profile.Width = streams.TextWidth(WidestText);
    }

    public void Write(InfoReport report)
    {
        int width = report.Sections.SelectMany(static section => section.Facts).Max(static fact => fact.Label.Length);
        WriteLine(report.File, Palette.StrongStyle);
        WriteLine(report.Summary);
        foreach (InfoSection section in report.Sections.Where(static section => !section.IsEmpty))
        {
            _console.WriteLine();
            WriteLine(section.Title, Palette.StrongStyle);
            foreach (InfoFact fact in section.Facts)
            {
                if (fact.Text is { } text)
                    WriteRow(fact.Label, width, text);
            }

            foreach (InfoItem item in section.Items.Take(MostItems))
                WriteRow(string.Empty, 0, item.Text);

            if (section.Items.Count > MostItems)
                WriteRow(string.Empty, 0, $"and {section.Items.Count - MostItems} more; --json lists them");
        }
    }

    private void WriteLine(string text, Style? style = null)
    {
        _console.Write(new Text(TerminalText.Clean(text), style));
        _console.WriteLine();
    }

    private void WriteRow(string label, int width, string text)
    {
        (label, string clean) = (TerminalText.Clean(label), TerminalText.Clean(text));
        if (!_isTerminal)
        {
            // A grid pads its lines to their full width.
            _console.WriteLine(width == 0 ? $"  {clean}" : $"  {label.PadRight(width)}  {clean}");
            return;
        }

        var grid = new Grid();
        if (width > 0)
            grid.AddColumn(new GridColumn { Width = width, Padding = new Padding(2, 0, 2, 0), NoWrap = true });

        grid.AddColumn(new GridColumn { Padding = new Padding(width > 0 ? 0 : 2, 0, 0, 0) });
        _console.Write(width > 0 ? grid.AddRow(new Text(label, Palette.DimStyle), new Text(clean)) : grid.AddRow(new Text(clean)));
    }
}
