namespace UnityEngine;

public class GUIContent(string text, string tooltip)
{
    public GUIContent(string text)
        : this(text, "")
    {
    }

    public static GUIContent none { get; } = new("");

    public string text { get; set; } = text;

    public string tooltip { get; set; } = tooltip;
}
