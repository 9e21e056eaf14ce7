namespace UnityEngine;

public sealed class Light : Behaviour
{
    public LightType type { get; set; } = LightType.Point;

    public Color color { get; set; } = Color.white;

    public float intensity { get; set; } = 1;

    public float range { get; set; } = 10;

    public LightShadows shadows { get; set; }
}

public enum LightType
{
    Spot = 0,
    Directional = 1,
    Point = 2,
}

public enum LightShadows
{
    None,
    Hard,
    Soft,
}
