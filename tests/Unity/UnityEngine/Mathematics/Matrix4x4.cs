namespace UnityEngine;

/// <summary>The columns of a matrix that multiplies column vectors from the left.</summary>
[Serializable]
public struct Matrix4x4(Vector4 column0, Vector4 column1, Vector4 column2, Vector4 column3) : IEquatable<Matrix4x4>
{
    public float m00 = column0.x;
    public float m10 = column0.y;
    public float m20 = column0.z;
    public float m30 = column0.w;
    public float m01 = column1.x;
    public float m11 = column1.y;
    public float m21 = column1.z;
    public float m31 = column1.w;
    public float m02 = column2.x;
    public float m12 = column2.y;
    public float m22 = column2.z;
    public float m32 = column2.w;
    public float m03 = column3.x;
    public float m13 = column3.y;
    public float m23 = column3.z;
    public float m33 = column3.w;

    public static Matrix4x4 identity => TRS(Vector3.zero, Quaternion.identity, Vector3.one);

    public static Matrix4x4 zero => default;

    public readonly Matrix4x4 inverse => System.Numerics.Matrix4x4.Invert(ToNumerics(), out System.Numerics.Matrix4x4 result) ? FromNumerics(result) : zero;

    public readonly Matrix4x4 transpose => FromNumerics(System.Numerics.Matrix4x4.Transpose(ToNumerics()));

    public readonly float determinant => ToNumerics().GetDeterminant();

    public readonly Quaternion rotation => Quaternion.LookRotation(GetColumn(2), GetColumn(1));

    public readonly Vector3 lossyScale =>
        new(((Vector3)GetColumn(0)).magnitude * (determinant < 0 ? -1 : 1), ((Vector3)GetColumn(1)).magnitude, ((Vector3)GetColumn(2)).magnitude);

    public static Matrix4x4 TRS(Vector3 pos, Quaternion q, Vector3 s)
    {
        Vector4 position = pos;
        position.w = 1;
        return new Matrix4x4(q * Vector3.right * s.x, q * Vector3.up * s.y, q * Vector3.forward * s.z, position);
    }

    public static Matrix4x4 Translate(Vector3 vector) => TRS(vector, Quaternion.identity, Vector3.one);

    public static Matrix4x4 Rotate(Quaternion q) => TRS(Vector3.zero, q, Vector3.one);

    public static Matrix4x4 Scale(Vector3 vector) => TRS(Vector3.zero, Quaternion.identity, vector);

    // System.Numerics multiplies row vectors from the right, so its matrices are the transposes, and products are swapped.
    public static Matrix4x4 operator *(Matrix4x4 lhs, Matrix4x4 rhs) => FromNumerics(rhs.ToNumerics() * lhs.ToNumerics());

    public static Vector4 operator *(Matrix4x4 lhs, Vector4 vector) => new(
        (lhs.m00 * vector.x) + (lhs.m01 * vector.y) + (lhs.m02 * vector.z) + (lhs.m03 * vector.w),
        (lhs.m10 * vector.x) + (lhs.m11 * vector.y) + (lhs.m12 * vector.z) + (lhs.m13 * vector.w),
        (lhs.m20 * vector.x) + (lhs.m21 * vector.y) + (lhs.m22 * vector.z) + (lhs.m23 * vector.w),
        (lhs.m30 * vector.x) + (lhs.m31 * vector.y) + (lhs.m32 * vector.z) + (lhs.m33 * vector.w));

    public static bool operator ==(Matrix4x4 lhs, Matrix4x4 rhs) =>
        lhs.GetColumn(0) == rhs.GetColumn(0) && lhs.GetColumn(1) == rhs.GetColumn(1) && lhs.GetColumn(2) == rhs.GetColumn(2) && lhs.GetColumn(3) == rhs.GetColumn(3);

    public static bool operator !=(Matrix4x4 lhs, Matrix4x4 rhs) => !(lhs == rhs);

    public readonly Vector4 GetColumn(int index) => index switch
    {
        0 => new Vector4(m00, m10, m20, m30),
        1 => new Vector4(m01, m11, m21, m31),
        2 => new Vector4(m02, m12, m22, m32),
        3 => new Vector4(m03, m13, m23, m33),
        _ => throw new IndexOutOfRangeException("Invalid column index!"),
    };

    public readonly Vector3 GetPosition() => GetColumn(3);

    public readonly Vector3 MultiplyPoint3x4(Vector3 point) => MultiplyVector(point) + GetPosition();

    public readonly Vector3 MultiplyPoint(Vector3 point)
    {
        Vector4 result = this * new Vector4(point.x, point.y, point.z, 1);
        return (Vector3)result / result.w;
    }

    public readonly Vector3 MultiplyVector(Vector3 vector) => this * (Vector4)vector;

    public override readonly bool Equals(object? other) => other is Matrix4x4 matrix && Equals(matrix);

    public readonly bool Equals(Matrix4x4 other) => ToNumerics().Equals(other.ToNumerics());

    public override readonly int GetHashCode() => ToNumerics().GetHashCode();

    private readonly System.Numerics.Matrix4x4 ToNumerics() =>
        new(m00, m10, m20, m30, m01, m11, m21, m31, m02, m12, m22, m32, m03, m13, m23, m33);

    private static Matrix4x4 FromNumerics(System.Numerics.Matrix4x4 m) => new(
        new Vector4(m.M11, m.M12, m.M13, m.M14), new Vector4(m.M21, m.M22, m.M23, m.M24), new Vector4(m.M31, m.M32, m.M33, m.M34), new Vector4(m.M41, m.M42, m.M43, m.M44));
}
