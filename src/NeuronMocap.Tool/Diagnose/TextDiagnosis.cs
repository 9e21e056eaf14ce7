using NeuronMocap.Diagnostics;
using NeuronMocap.Tool.Terminal;
using Spectre.Console;

namespace NeuronMocap.Tool.Diagnose;

/// <summary>Writes the steps as they happen, then the result. On a terminal, the text has colours and is wrapped.</summary>
internal sealed class TextDiagnosis(StandardStreams streams) : DiagnosisOutput
{
    private const int WidestText = 100;
    private const int NameWidth = 12;

    private readonly IAnsiConsole _console = new TextPage(streams, WidestText).Console;
    private readonly bool _isTerminal = streams.IsTerminal;

    public void Begin(string target)
    {
        _console.WriteLine($"Looking for frames from {TerminalText.Clean(target)}.");
        _console.WriteLine();
    }

    public override void Report(DiagnosisStep value)
    {
        (string word, Color color) = value.Outcome switch
        {
            StepOutcome.Ok => ("ok", Color.Green),
            StepOutcome.Warning => ("warn", Palette.Warning),
            _ => ("FAIL", Palette.Bad),
        };
        WriteRow(new Text(word, new Style(color)), value.Name.PadRight(NameWidth), value.Detail);
    }

    public override void Finish(StreamDiagnosis diagnosis)
    {
        Color color = !diagnosis.IsReceiving ? Palette.Bad : diagnosis.Verdict == DiagnosisVerdict.Receiving ? Color.Green : Palette.Warning;
        _console.WriteLine();
        _console.Write(new Text(diagnosis.Title.ToUpperInvariant(), new Style(color, decoration: Decoration.Bold)));
        _console.WriteLine();
        _console.Write(new Text(TerminalText.Clean(OptionNames.Translate(diagnosis.Summary))));
        _console.WriteLine();
        if (diagnosis.SampleCode is not { } code)
            return;

        _console.WriteLine();
        _console.Write(new Text(diagnosis.IsReceiving ? "To receive it:" : "To receive it as it is sent now:", Palette.DimStyle));
        _console.WriteLine();
        foreach (string line in code.Split('\n'))
            _console.WriteLine($"    {TerminalText.Clean(line.TrimEnd())}");
    }

    private void WriteRow(Text outcome, string name, string detail)
    {
        Grid grid = new Grid()
            .AddColumn(new GridColumn { Width = 4, Padding = new Padding(2, 0, 1, 0), NoWrap = true })
            .AddColumn(new GridColumn { Width = NameWidth, Padding = new Padding(0, 0, 1, 0), NoWrap = true })
            .AddColumn(new GridColumn { Padding = new Padding(0, 0, 0, 0) });
        string words = TerminalText.Clean(OptionNames.Translate(detail));
        if (_isTerminal)
        {
            _console.Write(grid.AddRow(outcome, new Text(name), new Text(words)));
            return;
        }

        // A grid pads its lines to full width.
        _console.Write(outcome);
        _console.WriteLine($"\t{name} {words}");
    }
}
