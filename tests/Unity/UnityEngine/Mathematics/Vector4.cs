namespace UnityEngine;

[Serializable]
public struct Vector4(float x, float y, float z, float w) : IEquatable<Vector4>
{
    public float x = x;
    public float y = y;
    public float z = z;
    public float w = w;

    public static Vector4 zero => default;

    public static Vector4 one => new(1, 1, 1, 1);

    public readonly float sqrMagnitude => (x * x) + (y * y) + (z * z) + (w * w);

    public readonly float magnitude => Mathf.Sqrt(sqrMagnitude);

    public static Vector4 operator +(Vector4 a, Vector4 b) => new(a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w);

    public static Vector4 operator -(Vector4 a, Vector4 b) => new(a.x - b.x, a.y - b.y, a.z - b.z, a.w - b.w);

    public static Vector4 operator *(Vector4 a, float d) => new(a.x * d, a.y * d, a.z * d, a.w * d);

    public static bool operator ==(Vector4 lhs, Vector4 rhs) => (lhs - rhs).sqrMagnitude < Vector3.EqualSquare;

    public static bool operator !=(Vector4 lhs, Vector4 rhs) => !(lhs == rhs);

    public static implicit operator Vector4(Vector3 v) => new(v.x, v.y, v.z, 0);

    public static implicit operator Vector3(Vector4 v) => new(v.x, v.y, v.z);

    public override readonly bool Equals(object? other) => other is Vector4 vector && Equals(vector);

    public readonly bool Equals(Vector4 other) => x.Equals(other.x) && y.Equals(other.y) && z.Equals(other.z) && w.Equals(other.w);

    public override readonly int GetHashCode() => HashCode.Combine(x, y, z, w);
}
