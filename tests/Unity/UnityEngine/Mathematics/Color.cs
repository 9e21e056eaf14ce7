namespace UnityEngine;

[Serializable]
public struct Color(float r, float g, float b, float a) : IEquatable<Color>
{
    public float r = r;
    public float g = g;
    public float b = b;
    public float a = a;

    public Color(float r, float g, float b)
        : this(r, g, b, 1)
    {
    }

    public static Color red => new(1, 0, 0);

    public static Color green => new(0, 1, 0);

    public static Color blue => new(0, 0, 1);

    public static Color white => new(1, 1, 1);

    public static Color black => new(0, 0, 0);

    public static Color yellow => new(1, 0.92f, 0.016f);

    public static Color cyan => new(0, 1, 1);

    public static Color magenta => new(1, 0, 1);

    public static Color gray => new(0.5f, 0.5f, 0.5f);

    public static Color grey => gray;

    public static Color clear => default;

    public static Color Lerp(Color a, Color b, float t)
    {
        t = Mathf.Clamp01(t);
        return new Color(a.r + ((b.r - a.r) * t), a.g + ((b.g - a.g) * t), a.b + ((b.b - a.b) * t), a.a + ((b.a - a.a) * t));
    }

    public static Color HSVToRGB(float H, float S, float V)
    {
        float Channel(float offset)
        {
            float k = Mathf.Repeat(offset + (H * 6), 6);
            return V - (V * S * Mathf.Clamp01(Mathf.Min(k, 4 - k)));
        }

        return new Color(Channel(5), Channel(3), Channel(1));
    }

    public static Color operator *(Color a, float b) => new(a.r * b, a.g * b, a.b * b, a.a * b);

    public static Color operator *(Color a, Color b) => new(a.r * b.r, a.g * b.g, a.b * b.b, a.a * b.a);

    public static Color operator +(Color a, Color b) => new(a.r + b.r, a.g + b.g, a.b + b.b, a.a + b.a);

    public static bool operator ==(Color lhs, Color rhs) => (Vector4)lhs == (Vector4)rhs;

    public static bool operator !=(Color lhs, Color rhs) => !(lhs == rhs);

    public static implicit operator Vector4(Color c) => new(c.r, c.g, c.b, c.a);

    public static implicit operator Color(Vector4 v) => new(v.x, v.y, v.z, v.w);

    public override readonly bool Equals(object? other) => other is Color color && Equals(color);

    public readonly bool Equals(Color other) => ((Vector4)this).Equals((Vector4)other);

    public override readonly int GetHashCode() => HashCode.Combine(r, g, b, a);
}
