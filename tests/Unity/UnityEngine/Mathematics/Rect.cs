namespace UnityEngine;

[Serializable]
public struct Rect(float x, float y, float width, float height) : IEquatable<Rect>
{
    public Rect(Vector2 position, Vector2 size)
        : this(position.x, position.y, size.x, size.y)
    {
    }

    public static Rect zero => default;

    public float x { get; set; } = x;

    public float y { get; set; } = y;

    public float width { get; set; } = width;

    public float height { get; set; } = height;

    public float xMin
    {
        readonly get => x;
        set => (width, x) = (xMax - value, value);
    }

    public float yMin
    {
        readonly get => y;
        set => (height, y) = (yMax - value, value);
    }

    public float xMax
    {
        readonly get => x + width;
        set => width = value - x;
    }

    public float yMax
    {
        readonly get => y + height;
        set => height = value - y;
    }

    public readonly Vector2 position => new(x, y);

    public readonly Vector2 size => new(width, height);

    public readonly Vector2 center => new(x + (width / 2), y + (height / 2));

    public static bool operator ==(Rect lhs, Rect rhs) => lhs.Equals(rhs);

    public static bool operator !=(Rect lhs, Rect rhs) => !lhs.Equals(rhs);

    public readonly bool Contains(Vector2 point) => point.x >= xMin && point.x < xMax && point.y >= yMin && point.y < yMax;

    public override readonly bool Equals(object? other) => other is Rect rect && Equals(rect);

    public readonly bool Equals(Rect other) => position.Equals(other.position) && size.Equals(other.size);

    public override readonly int GetHashCode() => HashCode.Combine(x, y, width, height);
}
