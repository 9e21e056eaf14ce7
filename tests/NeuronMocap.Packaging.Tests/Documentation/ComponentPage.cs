using System.Text;
using Microsoft.CodeAnalysis.CSharp.Syntax;

namespace NeuronMocap.Packaging.Tests.Documentation;

/// <summary>Generates Documentation~/components.md: every component and its fields, from the tooltips and ranges in the sources.</summary>
internal sealed class ComponentPage(PackageSources sources)
{
    private readonly StringBuilder _text = new();
    private readonly SortedSet<string> _groups = new(StringComparer.Ordinal);
    private readonly SortedSet<string> _choices = new(StringComparer.Ordinal);

    public static string Create(PackageSources sources) => new ComponentPage(sources).Write();

    private string Write()
    {
        Line("# Components");
        Line();
        Line("The components are in the menu *Add Component > NeuronMocap*. Each field has the same text as its tooltip. A test generates this page from the sources.");
        foreach ((string menu, TypeDeclarationSyntax type) in sources.Components)
            Section(menu, type.Identifier.Text);

        HashSet<string> written = new(StringComparer.Ordinal);
        if (_groups.Count > 0)
        {
            Line();
            Line("# Groups of fields");
        }

        while (_groups.Except(written).FirstOrDefault() is { } group)
        {
            written.Add(group);
            Section(InspectorField.Nicify(group), group);
        }

        Line();
        Line("# Choices");
        foreach (string choice in _choices)
            Choice(sources.FindEnum(choice)!);

        return _text.ToString();
    }

    private void Section(string title, string type)
    {
        Line();
        Line($"## {title}");
        Line();
        Line(sources.SummaryOf(type));
        InspectorField[] fields = [.. sources.FieldsOf(type)];
        if (fields.Length == 0)
            return;

        Line();
        Line("| field | | range | default |");
        Line("|---|---|---|---|");
        foreach (InspectorField field in fields)
        {
            if (field.Header is not null)
                Line($"| **{field.Header}** | | | |");

            Line($"| {field.Name} | {field.Tooltip}{LinkOf(field.Type)} | {RangeOf(field)} | {(HasInitial(type) ? InitialOf(field) : string.Empty)} |");
        }
    }

    private void Choice(EnumDeclarationSyntax choice)
    {
        Line();
        Line($"## {InspectorField.Nicify(choice.Identifier.Text)}");
        Line();
        Line(PackageSources.SummaryOf(choice));
        Line();
        foreach (EnumMemberDeclarationSyntax member in choice.Members)
            Line($"- *{InspectorField.Nicify(member.Identifier.Text)}*: {PackageSources.SummaryOf(member)}");
    }

    private string LinkOf(string fieldType)
    {
        string type = ElementOf(fieldType);
        if (sources.FindEnum(type) is { } choice)
        {
            _choices.Add(choice.Identifier.Text);
            return $" See [{InspectorField.Nicify(choice.Identifier.Text)}](#{AnchorOf(choice.Identifier.Text)}).";
        }

        if (sources.Components.Any(component => component.Type.Identifier.Text == type) || !sources.HasFields(type))
            return string.Empty;

        _groups.Add(type);
        return $" See [{InspectorField.Nicify(type)}](#{AnchorOf(type)}).";
    }

    private static string AnchorOf(string name) => InspectorField.Nicify(name).ToLowerInvariant().Replace(' ', '-');

    private static string ElementOf(string type) => type.StartsWith("List<", StringComparison.Ordinal) ? type[5..^1] : type.TrimEnd(']', '[');

    private string RangeOf(InspectorField field) => field.Range ?? (field.Type, sources.FindEnum(field.Type)) switch
    {
        ("bool", _) => "on, off",
        (_, not null) => "a choice",
        ("string", _) => "text",
        ("int" or "float" or "double" or "long", _) => "any number",
        ({ } type, _) when type.StartsWith("UnityEvent", StringComparison.Ordinal) => "what to call",
        _ => InspectorField.Nicify(ElementOf(field.Type).Split('.')[^1]) + (field.Type == ElementOf(field.Type) ? string.Empty : ", any number of them"),
    };

    // The component that has a struct sets its values, and the inspector those of a new element of a list.
    private bool HasInitial(string type) => !sources.IsStruct(type);

    private string InitialOf(InspectorField field) => (field.Initial, field.Type) switch
    {
        ("true", _) => "on",
        ("false" or null, "bool") => "off",
        ("string.Empty" or "\"\"" or null, "string") => "empty",
        (null, "int" or "float" or "double" or "long") => "0",
        (null, _) => sources.FindEnum(field.Type) is { } choice ? InspectorField.Nicify(FirstOf(choice)) : "none",
        ({ } text, _) when text.StartsWith('"') => text.Trim('"'),
        ({ } text, _) when char.IsDigit(text[0]) || text[0] == '-' => text.TrimEnd('f'),
        ({ } text, _) when sources.FindEnum(field.Type) is not null => InspectorField.Nicify(text.Split('.')[^1]),
        _ => string.Empty,
    };

    private static string FirstOf(EnumDeclarationSyntax choice) =>
        (choice.Members.FirstOrDefault(static member => member.EqualsValue?.Value.ToString() == "0") ?? choice.Members[0]).Identifier.Text;

    private void Line(string line = "") => _text.Append(line).Append('\n');
}
