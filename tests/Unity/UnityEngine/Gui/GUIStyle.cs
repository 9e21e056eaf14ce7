namespace UnityEngine;

public sealed class GUIStyle
{
    public GUIStyle()
    {
    }

    public GUIStyle(GUIStyle other)
    {
        name = other.name;
        normal.textColor = other.normal.textColor;
    }

    public string name { get; set; } = "";

    public GUIStyleState normal { get; set; } = new();

    public bool wordWrap { get; set; }

    public bool richText { get; set; }

    public FontStyle fontStyle { get; set; }

    public static implicit operator GUIStyle(string name) => new() { name = name };
}
