namespace UnityEngine;

public struct Color32(byte r, byte g, byte b, byte a)
{
    public byte r = r;
    public byte g = g;
    public byte b = b;
    public byte a = a;

    public static implicit operator Color(Color32 c) => new(c.r / 255f, c.g / 255f, c.b / 255f, c.a / 255f);
}
