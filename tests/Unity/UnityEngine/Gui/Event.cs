namespace UnityEngine;

public sealed class Event
{
    public static Event current { get; set; } = new() { type = EventType.Repaint };

    public EventType type { get; set; }

    public Vector2 mousePosition { get; set; }

    public Vector2 delta { get; set; }

    public int button { get; set; }

    public void Use() => type = EventType.Used;
}
