using System.Globalization;

namespace UnityEngine;

[Serializable]
public struct Quaternion(float x, float y, float z, float w) : IEquatable<Quaternion>
{
    public const float kEpsilon = 0.000001f;

    public float x = x;
    public float y = y;
    public float z = z;
    public float w = w;

    public static Quaternion identity => new(0, 0, 0, 1);

    public Vector3 eulerAngles
    {
        readonly get => ToEuler(this);
        set => this = Euler(value);
    }

    public readonly Quaternion normalized => Normalize(this);

    public float this[int index]
    {
        readonly get => index switch { 0 => x, 1 => y, 2 => z, 3 => w, _ => throw new IndexOutOfRangeException("Invalid Quaternion index!") };

        set
        {
            switch (index)
            {
                case 0: x = value; break;
                case 1: y = value; break;
                case 2: z = value; break;
                case 3: w = value; break;
                default: throw new IndexOutOfRangeException("Invalid Quaternion index!");
            }
        }
    }

    public static float Dot(Quaternion a, Quaternion b) => (a.x * b.x) + (a.y * b.y) + (a.z * b.z) + (a.w * b.w);

    /// <summary>Turns about z first, then x, then y, in degrees: Y * X * Z.</summary>
    public static Quaternion Euler(float x, float y, float z) =>
        AngleAxis(y, Vector3.up) * AngleAxis(x, Vector3.right) * AngleAxis(z, Vector3.forward);

    public static Quaternion Euler(Vector3 euler) => Euler(euler.x, euler.y, euler.z);

    public static Quaternion AngleAxis(float angle, Vector3 axis)
    {
        float length = axis.magnitude;
        if (length < Vector3.SmallestLength)
            return identity;

        double half = angle * (Math.PI / 180) / 2;
        float sin = (float)Math.Sin(half) / length;
        return new Quaternion(axis.x * sin, axis.y * sin, axis.z * sin, (float)Math.Cos(half));
    }

    public static Quaternion LookRotation(Vector3 forward) => LookRotation(forward, Vector3.up);

    public static Quaternion LookRotation(Vector3 forward, Vector3 upwards)
    {
        if (forward.magnitude < Vector3.SmallestLength)
        {
            Debug.Log("Look rotation viewing vector is zero");
            return identity;
        }

        Vector3 z = forward.normalized;
        Vector3 x = Vector3.Cross(upwards, z).normalized;
        return x == Vector3.zero ? FromToRotation(Vector3.forward, z) : FromAxes(x, Vector3.Cross(z, x), z);
    }

    public static Quaternion FromToRotation(Vector3 fromDirection, Vector3 toDirection)
    {
        Vector3 from = fromDirection.normalized;
        Vector3 to = toDirection.normalized;
        float cos = Vector3.Dot(from, to);
        if (cos < -0.99999f)
        {
            Vector3 axis = Vector3.Cross(from, Mathf.Abs(from.x) < 0.9f ? Vector3.right : Vector3.up);
            return AngleAxis(180, axis);
        }

        Vector3 cross = Vector3.Cross(from, to);
        return Normalize(new Quaternion(cross.x, cross.y, cross.z, 1 + cos));
    }

    public static Quaternion Inverse(Quaternion rotation)
    {
        float square = Dot(rotation, rotation);
        return square == 0 ? rotation : new Quaternion(-rotation.x / square, -rotation.y / square, -rotation.z / square, rotation.w / square);
    }

    public static Quaternion Normalize(Quaternion q)
    {
        float length = Mathf.Sqrt(Dot(q, q));
        return length < Mathf.Epsilon ? identity : new Quaternion(q.x / length, q.y / length, q.z / length, q.w / length);
    }

    public static Quaternion Lerp(Quaternion a, Quaternion b, float t) => LerpUnclamped(a, b, Mathf.Clamp01(t));

    public static Quaternion LerpUnclamped(Quaternion a, Quaternion b, float t) => Mix(a, b, 1 - t, Dot(a, b) < 0 ? -t : t);

    public static Quaternion Slerp(Quaternion a, Quaternion b, float t) => SlerpUnclamped(a, b, Mathf.Clamp01(t));

    public static Quaternion SlerpUnclamped(Quaternion a, Quaternion b, float t)
    {
        float cos = Dot(a, b);
        float sign = cos < 0 ? -1 : 1;
        if (Mathf.Abs(cos) > 0.9995f)
            return LerpUnclamped(a, b, t);

        float angle = Mathf.Acos(Mathf.Abs(cos));
        float sin = Mathf.Sin(angle);
        return Mix(a, b, Mathf.Sin((1 - t) * angle) / sin, Mathf.Sin(t * angle) / sin * sign);
    }

    public static Quaternion RotateTowards(Quaternion from, Quaternion to, float maxDegreesDelta)
    {
        float angle = Angle(from, to);
        return angle == 0 ? to : SlerpUnclamped(from, to, Mathf.Min(1, maxDegreesDelta / angle));
    }

    public static float Angle(Quaternion a, Quaternion b)
    {
        float cos = Mathf.Min(Mathf.Abs(Dot(a, b)), 1);
        return IsEqual(cos) ? 0 : Mathf.Acos(cos) * 2 * Mathf.Rad2Deg;
    }

    public static Quaternion operator *(Quaternion lhs, Quaternion rhs) => new(
        (lhs.w * rhs.x) + (lhs.x * rhs.w) + (lhs.y * rhs.z) - (lhs.z * rhs.y),
        (lhs.w * rhs.y) + (lhs.y * rhs.w) + (lhs.z * rhs.x) - (lhs.x * rhs.z),
        (lhs.w * rhs.z) + (lhs.z * rhs.w) + (lhs.x * rhs.y) - (lhs.y * rhs.x),
        (lhs.w * rhs.w) - (lhs.x * rhs.x) - (lhs.y * rhs.y) - (lhs.z * rhs.z));

    public static Vector3 operator *(Quaternion rotation, Vector3 point)
    {
        var axis = new Vector3(rotation.x, rotation.y, rotation.z);
        Vector3 twice = Vector3.Cross(axis, point) * 2;
        return point + (twice * rotation.w) + Vector3.Cross(axis, twice);
    }

    public static bool operator ==(Quaternion lhs, Quaternion rhs) => IsEqual(Dot(lhs, rhs));

    public static bool operator !=(Quaternion lhs, Quaternion rhs) => !(lhs == rhs);

    public void Set(float newX, float newY, float newZ, float newW) => this = new Quaternion(newX, newY, newZ, newW);

    public void Normalize() => this = Normalize(this);

    public readonly void ToAngleAxis(out float angle, out Vector3 axis)
    {
        Quaternion unit = Normalize(this);
        var direction = new Vector3(unit.x, unit.y, unit.z);
        angle = 2 * Mathf.Acos(Mathf.Clamp(unit.w, -1, 1)) * Mathf.Rad2Deg;
        axis = direction.magnitude < Vector3.SmallestLength ? Vector3.right : direction.normalized;
    }

    public void SetLookRotation(Vector3 view, Vector3 up) => this = LookRotation(view, up);

    public override readonly bool Equals(object? other) => other is Quaternion quaternion && Equals(quaternion);

    public readonly bool Equals(Quaternion other) => x.Equals(other.x) && y.Equals(other.y) && z.Equals(other.z) && w.Equals(other.w);

    public override readonly int GetHashCode() => HashCode.Combine(x, y, z, w);

    public override readonly string ToString() => ToString("F5");

    public readonly string ToString(string format) => string.Join(
        ", ",
        "(" + x.ToString(format, CultureInfo.InvariantCulture),
        y.ToString(format, CultureInfo.InvariantCulture),
        z.ToString(format, CultureInfo.InvariantCulture),
        w.ToString(format, CultureInfo.InvariantCulture) + ")");

    internal static Quaternion FromAxes(Vector3 x, Vector3 y, Vector3 z)
    {
        // Finds the largest of the four components first, so that no division is by a small number.
        float trace = x.x + y.y + z.z;
        if (trace > 0)
            return Normalize(new Quaternion(y.z - z.y, z.x - x.z, x.y - y.x, 1 + trace));

        if (x.x >= y.y && x.x >= z.z)
            return Normalize(new Quaternion(1 + x.x - y.y - z.z, x.y + y.x, z.x + x.z, y.z - z.y));

        return y.y >= z.z
            ? Normalize(new Quaternion(x.y + y.x, 1 + y.y - x.x - z.z, y.z + z.y, z.x - x.z))
            : Normalize(new Quaternion(z.x + x.z, y.z + z.y, 1 + z.z - x.x - y.y, x.y - y.x));
    }

    private static bool IsEqual(float dot) => dot > 1 - kEpsilon;

    private static Quaternion Mix(Quaternion a, Quaternion b, float ofA, float ofB) =>
        Normalize(new Quaternion((a.x * ofA) + (b.x * ofB), (a.y * ofA) + (b.y * ofB), (a.z * ofA) + (b.z * ofB), (a.w * ofA) + (b.w * ofB)));

    // Angles of Y * X * Z, each from 0 to 360 degrees.
    private static Vector3 ToEuler(Quaternion rotation)
    {
        Quaternion q = Normalize(rotation);
        float sin = 2 * ((q.w * q.x) - (q.y * q.z));
        float x;
        float y;
        float z;
        if (Mathf.Abs(sin) > 0.999999f)
        {
            x = Mathf.Sign(sin) * Mathf.PI / 2;
            y = 2 * Mathf.Atan2(q.y, q.w);
            z = 0;
        }
        else
        {
            x = Mathf.Asin(sin);
            y = Mathf.Atan2(2 * ((q.w * q.y) + (q.x * q.z)), 1 - (2 * ((q.x * q.x) + (q.y * q.y))));
            z = Mathf.Atan2(2 * ((q.w * q.z) + (q.x * q.y)), 1 - (2 * ((q.x * q.x) + (q.z * q.z))));
        }

        return new Vector3(Positive(x), Positive(y), Positive(z));
    }

    private static float Positive(float radians) => Mathf.Repeat(radians * Mathf.Rad2Deg, 360);
}
