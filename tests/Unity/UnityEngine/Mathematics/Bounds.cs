namespace UnityEngine;

[Serializable]
public struct Bounds(Vector3 center, Vector3 size) : IEquatable<Bounds>
{
    public Vector3 center { get; set; } = center;

    public Vector3 extents { get; set; } = size / 2;

    public Vector3 size
    {
        readonly get => extents * 2;
        set => extents = value / 2;
    }

    public readonly Vector3 min => center - extents;

    public readonly Vector3 max => center + extents;

    public static bool operator ==(Bounds lhs, Bounds rhs) => lhs.center == rhs.center && lhs.extents == rhs.extents;

    public static bool operator !=(Bounds lhs, Bounds rhs) => !(lhs == rhs);

    public void Encapsulate(Vector3 point)
    {
        Vector3 low = Vector3.Min(min, point);
        Vector3 high = Vector3.Max(max, point);
        (center, extents) = ((low + high) / 2, (high - low) / 2);
    }

    public readonly bool Contains(Vector3 point) => Vector3.Min(min, point) == min && Vector3.Max(max, point) == max;

    public override readonly bool Equals(object? other) => other is Bounds bounds && Equals(bounds);

    public readonly bool Equals(Bounds other) => center.Equals(other.center) && extents.Equals(other.extents);

    public override readonly int GetHashCode() => HashCode.Combine(center, extents);
}
