namespace UnityEngine;

public sealed class TextMesh : Component
{
    public string text { get; set; } = "";

    public float characterSize { get; set; } = 1;

    public int fontSize { get; set; }

    public Color color { get; set; } = Color.white;

    public TextAnchor anchor { get; set; }

    public TextAlignment alignment { get; set; }
}

public enum TextAnchor
{
    UpperLeft,
    UpperCenter,
    UpperRight,
    MiddleLeft,
    MiddleCenter,
    MiddleRight,
    LowerLeft,
    LowerCenter,
    LowerRight,
}

public enum TextAlignment
{
    Left,
    Center,
    Right,
}
