using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Info;

/// <summary>A report as readable text.</summary>
internal sealed class InfoPage(StandardStreams streams)
{
    private const int WidestText = 110;
    private const int MaxItems = 20;

    private readonly TextPage _page = new(streams, WidestText);

    /// <summary>Writes a report.</summary>
    /// <param name="report">The report.</param>
    /// <param name="followsAnother">Whether another report precedes it.</param>
    public void Write(InfoReport report, bool followsAnother)
    {
        if (followsAnother)
            _page.WriteLine();

        int width = report.Sections.SelectMany(static section => section.Facts).Max(static fact => fact.Label.Length);
        _page.WriteLine(report.File, Palette.StrongStyle);
        _page.WriteLine(report.Summary);
        foreach (InfoSection section in report.Sections.Where(static section => !section.IsEmpty))
        {
            _page.WriteLine();
            _page.WriteLine(section.Title, Palette.StrongStyle);
            foreach (InfoFact fact in section.Facts)
            {
                if (fact.Text is { } text)
                    _page.WriteRow(fact.Label, width, text);
            }

            foreach (InfoItem item in section.Items.Take(MaxItems))
                _page.WriteRow(string.Empty, 0, item.Text);

            if (section.Items.Count > MaxItems)
                _page.WriteRow(string.Empty, 0, $"and {section.Items.Count - MaxItems} more; --json lists them");
        }
    }
}
