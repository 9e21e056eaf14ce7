namespace UnityEngine.StandIn;

/// <summary>A control drawn by a pass: a label, a field, a button.</summary>
internal sealed class GuiControl(string kind, string label, string value, bool isEnabled, Color? color, int row, string tooltip)
{
    /// <summary>"Label", "Property", "Button", "Toggle", "HelpBox", "Rect".</summary>
    public string Kind => kind;

    /// <summary>Its text, or the name of the field.</summary>
    public string Label => label;

    /// <summary>The value of the field. For a help box, its kind.</summary>
    public string Value => value;

    /// <summary>False if disabled.</summary>
    public bool IsEnabled => isEnabled;

    /// <summary>The colour of the text. Null: that of the skin.</summary>
    public Color? Color => color;

    /// <summary>The number of the row. Controls in one row have the same number.</summary>
    public int Row => row;

    /// <summary>The tooltip of a field.</summary>
    public string Tooltip => tooltip;

    public override string ToString() => $"{kind} {label}{(value.Length > 0 ? $": {value}" : "")}{(isEnabled ? "" : " (disabled)")}";
}
