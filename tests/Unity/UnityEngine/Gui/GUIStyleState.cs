namespace UnityEngine;

public sealed class GUIStyleState
{
    public Color textColor { get; set; } = Color.black;
}
