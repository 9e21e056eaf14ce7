namespace UnityEngine;

public struct Vector2Int(int x, int y) : IEquatable<Vector2Int>
{
    public int x { get; set; } = x;

    public int y { get; set; } = y;

    public static bool operator ==(Vector2Int lhs, Vector2Int rhs) => lhs.Equals(rhs);

    public static bool operator !=(Vector2Int lhs, Vector2Int rhs) => !lhs.Equals(rhs);

    public readonly bool Equals(Vector2Int other) => x == other.x && y == other.y;

    public override readonly bool Equals(object? obj) => obj is Vector2Int other && Equals(other);

    public override readonly int GetHashCode() => HashCode.Combine(x, y);

    public override readonly string ToString() => $"({x}, {y})";
}
