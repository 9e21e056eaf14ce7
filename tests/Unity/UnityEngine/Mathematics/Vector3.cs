using System.Globalization;

namespace UnityEngine;

[Serializable]
public struct Vector3(float x, float y, float z) : IEquatable<Vector3>
{
    public const float kEpsilon = 0.00001f;

    internal const float SmallestLength = 1e-5f;

    // Unity treats vectors closer than 1e-5 as equal.
    internal const float EqualSquare = 9.99999944e-11f;

    public float x = x;
    public float y = y;
    public float z = z;

    public Vector3(float x, float y)
        : this(x, y, 0)
    {
    }

    public static Vector3 zero => default;

    public static Vector3 one => new(1, 1, 1);

    public static Vector3 up => new(0, 1, 0);

    public static Vector3 down => new(0, -1, 0);

    public static Vector3 left => new(-1, 0, 0);

    public static Vector3 right => new(1, 0, 0);

    public static Vector3 forward => new(0, 0, 1);

    public static Vector3 back => new(0, 0, -1);

    public static Vector3 positiveInfinity => one * float.PositiveInfinity;

    public static Vector3 negativeInfinity => one * float.NegativeInfinity;

    public readonly float magnitude => Mathf.Sqrt(sqrMagnitude);

    public readonly float sqrMagnitude => (x * x) + (y * y) + (z * z);

    public readonly Vector3 normalized => Normalize(this);

    public float this[int index]
    {
        readonly get => index switch { 0 => x, 1 => y, 2 => z, _ => throw new IndexOutOfRangeException("Invalid Vector3 index!") };

        set
        {
            switch (index)
            {
                case 0: x = value; break;
                case 1: y = value; break;
                case 2: z = value; break;
                default: throw new IndexOutOfRangeException("Invalid Vector3 index!");
            }
        }
    }

    public static float Dot(Vector3 lhs, Vector3 rhs) => (lhs.x * rhs.x) + (lhs.y * rhs.y) + (lhs.z * rhs.z);

    public static Vector3 Cross(Vector3 lhs, Vector3 rhs) =>
        new((lhs.y * rhs.z) - (lhs.z * rhs.y), (lhs.z * rhs.x) - (lhs.x * rhs.z), (lhs.x * rhs.y) - (lhs.y * rhs.x));

    public static float Distance(Vector3 a, Vector3 b) => (a - b).magnitude;

    public static float Magnitude(Vector3 vector) => vector.magnitude;

    public static float SqrMagnitude(Vector3 vector) => vector.sqrMagnitude;

    public static Vector3 Normalize(Vector3 value) => value.magnitude > SmallestLength ? value / value.magnitude : zero;

    public static Vector3 Scale(Vector3 a, Vector3 b) => new(a.x * b.x, a.y * b.y, a.z * b.z);

    public static Vector3 Min(Vector3 lhs, Vector3 rhs) => new(Mathf.Min(lhs.x, rhs.x), Mathf.Min(lhs.y, rhs.y), Mathf.Min(lhs.z, rhs.z));

    public static Vector3 Max(Vector3 lhs, Vector3 rhs) => new(Mathf.Max(lhs.x, rhs.x), Mathf.Max(lhs.y, rhs.y), Mathf.Max(lhs.z, rhs.z));

    public static Vector3 Lerp(Vector3 a, Vector3 b, float t) => LerpUnclamped(a, b, Mathf.Clamp01(t));

    public static Vector3 LerpUnclamped(Vector3 a, Vector3 b, float t) => a + ((b - a) * t);

    public static Vector3 MoveTowards(Vector3 current, Vector3 target, float maxDistanceDelta)
    {
        float distance = Distance(current, target);
        return distance == 0 || distance <= maxDistanceDelta ? target : current + ((target - current) / distance * maxDistanceDelta);
    }

    public static Vector3 Project(Vector3 vector, Vector3 onNormal) =>
        onNormal.sqrMagnitude < Mathf.Epsilon ? zero : onNormal * (Dot(vector, onNormal) / onNormal.sqrMagnitude);

    public static Vector3 ProjectOnPlane(Vector3 vector, Vector3 planeNormal) => vector - Project(vector, planeNormal);

    public static Vector3 Reflect(Vector3 inDirection, Vector3 inNormal) => inDirection - (inNormal * (2 * Dot(inNormal, inDirection)));

    public static float Angle(Vector3 from, Vector3 to)
    {
        float lengths = Mathf.Sqrt(from.sqrMagnitude * to.sqrMagnitude);
        return lengths < 1e-15f ? 0 : Mathf.Acos(Mathf.Clamp(Dot(from, to) / lengths, -1, 1)) * Mathf.Rad2Deg;
    }

    public static float SignedAngle(Vector3 from, Vector3 to, Vector3 axis) =>
        Angle(from, to) * (Dot(axis, Cross(from, to)) >= 0 ? 1 : -1);

    public static Vector3 ClampMagnitude(Vector3 vector, float maxLength) =>
        vector.sqrMagnitude > maxLength * maxLength ? vector.normalized * maxLength : vector;

    public static Vector3 SmoothDamp(
        Vector3 current, Vector3 target, ref Vector3 currentVelocity, float smoothTime, float maxSpeed, float deltaTime) =>
        new(
            Mathf.SmoothDamp(current.x, target.x, ref currentVelocity.x, smoothTime, maxSpeed, deltaTime),
            Mathf.SmoothDamp(current.y, target.y, ref currentVelocity.y, smoothTime, maxSpeed, deltaTime),
            Mathf.SmoothDamp(current.z, target.z, ref currentVelocity.z, smoothTime, maxSpeed, deltaTime));

    public static Vector3 operator +(Vector3 a, Vector3 b) => new(a.x + b.x, a.y + b.y, a.z + b.z);

    public static Vector3 operator -(Vector3 a, Vector3 b) => new(a.x - b.x, a.y - b.y, a.z - b.z);

    public static Vector3 operator -(Vector3 a) => new(-a.x, -a.y, -a.z);

    public static Vector3 operator *(Vector3 a, float d) => new(a.x * d, a.y * d, a.z * d);

    public static Vector3 operator *(float d, Vector3 a) => a * d;

    public static Vector3 operator /(Vector3 a, float d) => new(a.x / d, a.y / d, a.z / d);

    public static bool operator ==(Vector3 lhs, Vector3 rhs) => (lhs - rhs).sqrMagnitude < EqualSquare;

    public static bool operator !=(Vector3 lhs, Vector3 rhs) => !(lhs == rhs);

    public void Set(float newX, float newY, float newZ) => this = new Vector3(newX, newY, newZ);

    public void Normalize() => this = Normalize(this);

    public void Scale(Vector3 scale) => this = Scale(this, scale);

    public override readonly bool Equals(object? other) => other is Vector3 vector && Equals(vector);

    public readonly bool Equals(Vector3 other) => x.Equals(other.x) && y.Equals(other.y) && z.Equals(other.z);

    public override readonly int GetHashCode() => HashCode.Combine(x, y, z);

    public override readonly string ToString() => ToString("F2");

    public readonly string ToString(string format) =>
        $"({x.ToString(format, CultureInfo.InvariantCulture)}, {y.ToString(format, CultureInfo.InvariantCulture)}, {z.ToString(format, CultureInfo.InvariantCulture)})";
}
