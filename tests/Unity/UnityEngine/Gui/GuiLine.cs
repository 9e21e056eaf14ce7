namespace UnityEngine.StandIn;

/// <summary>A line of Handles, in the pixels of the window.</summary>
internal readonly struct GuiLine(Vector2 from, Vector2 to, Color color, float width)
{
    public Vector2 From => from;

    public Vector2 To => to;

    public Color Color => color;

    /// <summary>1, or the width of an anti-aliased line.</summary>
    public float Width => width;
}
