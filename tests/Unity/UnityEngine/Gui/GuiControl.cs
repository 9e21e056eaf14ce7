namespace UnityEngine.StandIn;

/// <summary>What a pass drew: a label, a field, a button.</summary>
internal sealed class GuiControl(string kind, string label, string value, bool isEnabled, Color? color, int row, string tooltip)
{
    /// <summary>"Label", "Property", "Button", "Toggle", "HelpBox", "Rect".</summary>
    public string Kind => kind;

    /// <summary>Its text, or the name of the field.</summary>
    public string Label => label;

    /// <summary>What the field shows; of a help box its kind.</summary>
    public string Value => value;

    /// <summary>False when greyed out.</summary>
    public bool IsEnabled => isEnabled;

    /// <summary>Of the text; null: that of the skin.</summary>
    public Color? Color => color;

    /// <summary>Number of the line: those of one line have one number.</summary>
    public int Row => row;

    /// <summary>Of a field.</summary>
    public string Tooltip => tooltip;

    public override string ToString() => $"{kind} {label}{(value.Length > 0 ? $": {value}" : "")}{(isEnabled ? "" : " (disabled)")}";
}
