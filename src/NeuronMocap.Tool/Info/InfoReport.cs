using System.Text.Json.Nodes;

namespace NeuronMocap.Tool.Info;

/// <summary>The report of info about a file, for text and JSON.</summary>
/// <param name="file">Name of the file.</param>
/// <param name="kind">One word for the kind of the file, for JSON.</param>
/// <param name="summary">A summary in one line.</param>
internal sealed class InfoReport(string file, string kind, string summary)
{
    private readonly List<InfoSection> _sections = [];

    public string File => file;

    public string Kind => kind;

    public string Summary => summary;

    public IReadOnlyList<InfoSection> Sections => _sections;

    /// <summary>Adds a section. The name is that of its JSON member.</summary>
    public InfoSection Section(string name, string title)
    {
        var section = new InfoSection(name, title);
        _sections.Add(section);
        return section;
    }
}

/// <summary>A section of a report: related facts, or a list of similar items.</summary>
internal sealed class InfoSection(string name, string title)
{
    private readonly List<InfoFact> _facts = [];
    private readonly List<InfoItem> _items = [];

    public string Name => name;

    public string Title => title;

    public IReadOnlyList<InfoFact> Facts => _facts;

    public IReadOnlyList<InfoItem> Items => _items;

    public bool IsEmpty => _facts.Count == 0 && _items.Count == 0;

    /// <summary>Adds a fact.</summary>
    /// <param name="name">Name of its JSON member.</param>
    /// <param name="label">Label in the text. Empty to continue the previous fact.</param>
    /// <param name="text">The text; null for a fact that only JSON contains.</param>
    /// <param name="value">The JSON value; null for none.</param>
    public InfoSection Add(string name, string label, string? text, JsonNode? value)
    {
        _facts.Add(new InfoFact(name, label, text, value));
        return this;
    }

    public InfoSection Add(string name, string label, string text) => Add(name, label, text, text);

    public InfoSection Add(string name, string label, string? text, double value) =>
        Add(name, label, text, double.IsFinite(value) ? JsonValue.Create(Math.Round(value, 6)) : null);

    /// <summary>Adds a finding.</summary>
    /// <param name="code">A word for JSON.</param>
    /// <param name="text">The text.</param>
    /// <param name="line">Line of the file, from 1; 0 for none.</param>
    /// <param name="column">Byte of that line, from 1; 0 for none.</param>
    public void Remark(string code, string text, int line = 0, int column = 0)
    {
        var json = new JsonObject { ["code"] = code, ["text"] = text };
        if (line > 0)
            json["line"] = line;
        if (column > 0)
            json["column"] = column;

        string place = (line, column) switch
        {
            (0, _) => string.Empty,
            (_, 0) => $"line {line}: ",
            _ => $"line {line}, column {column}: ",
        };
        Item(place + text, json);
    }

    /// <summary>Adds an item of a list.</summary>
    public void Item(string text, JsonObject json) => _items.Add(new InfoItem(text, json));
}

/// <summary>One line of a section: see <see cref="InfoSection.Add(string, string, string?, JsonNode?)"/>.</summary>
internal readonly record struct InfoFact(string Name, string Label, string? Text, JsonNode? Value);

/// <summary>An item of a list, as text and as JSON.</summary>
internal readonly record struct InfoItem(string Text, JsonObject Json);
