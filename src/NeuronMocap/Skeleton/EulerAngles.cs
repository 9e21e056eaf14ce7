using System.Numerics;

namespace NeuronMocap.Skeleton;

/// <summary>
/// Converts between the stream's three angles in degrees and quaternions. The components of a <see cref="Vector3"/> follow the rotation order: for
/// YXZ, component X is the angle about Y.
/// </summary>
public static class EulerAngles
{
    /// <summary>Converts three angles to a quaternion.</summary>
    /// <param name="degrees">Angles of any size in degrees, in the order in which they are applied.</param>
    /// <param name="order">The rotation order of the angles.</param>
    /// <returns>A unit quaternion, for right-handed axes.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The rotation order is not defined.</exception>
    public static Quaternion ToQuaternion(Vector3 degrees, RotationOrder order)
    {
        var turn = new RotationComposer(order);
        Span<float> angles = stackalloc float[HalfAngles.Granularity];
        Span<float> sines = stackalloc float[HalfAngles.Granularity];
        Span<float> cosines = stackalloc float[HalfAngles.Granularity];
        angles[0] = degrees.X;
        angles[1] = degrees.Y;
        angles[2] = degrees.Z;
        HalfAngles.SinCos(angles, sines, cosines);
        return turn.Compose(new Vector3(sines[0], sines[1], sines[2]), new Vector3(cosines[0], cosines[1], cosines[2]));
    }

    /// <summary>Converts a rotation to three angles.</summary>
    /// <param name="rotation">A quaternion of any length except zero.</param>
    /// <param name="order">The rotation order of the result.</param>
    /// <returns>
    /// Degrees in the order in which they are applied. The first and third are within [-180, 180], the second within [-90, 90]. If the second is 90
    /// degrees, the first and third turn about the same line. The third is then zero.
    /// </returns>
    /// <exception cref="ArgumentOutOfRangeException">The rotation order is not defined.</exception>
    public static Vector3 FromQuaternion(Quaternion rotation, RotationOrder order)
    {
        (int i, int j, int k) = Axes(order);
        double sign = (j - i + 3) % 3 == 1 ? 1 : -1;
        var matrix = new RotationMatrix(rotation);

        double sine = Math.Max(-1, Math.Min(1, sign * matrix[i, k]));
        double second = Math.Asin(sine);
        bool locked = 1 - Math.Abs(sine) < 1e-12;
        double first = locked
            ? Math.Atan2(sign * matrix[k, j], matrix[j, j])
            : Math.Atan2(-sign * matrix[j, k], matrix[k, k]);
        double third = locked ? 0 : Math.Atan2(-sign * matrix[i, j], matrix[i, i]);
        return new Vector3(Degrees(first), Degrees(second), Degrees(third));
    }

    internal static (int First, int Second, int Third) Axes(RotationOrder order) => order switch
    {
        RotationOrder.XZY => (0, 2, 1),
        RotationOrder.YXZ => (1, 0, 2),
        RotationOrder.XYZ => (0, 1, 2),
        RotationOrder.YZX => (1, 2, 0),
        RotationOrder.ZXY => (2, 0, 1),
        RotationOrder.ZYX => (2, 1, 0),
        _ => throw new ArgumentOutOfRangeException(nameof(order), order, "The order must be one of the six rotation orders, 0 to 5."),
    };

    private static float Degrees(double radians) => (float)(radians * (180 / Math.PI));

    // In double precision. Near the pole of the second angle, single precision costs a tenth of a degree.
    private readonly ref struct RotationMatrix
    {
        private readonly double _x;
        private readonly double _y;
        private readonly double _z;
        private readonly double _w;

        public RotationMatrix(Quaternion q)
        {
            double length = Math.Sqrt(((double)q.X * q.X) + ((double)q.Y * q.Y) + ((double)q.Z * q.Z) + ((double)q.W * q.W));
            _x = q.X / length;
            _y = q.Y / length;
            _z = q.Z / length;
            _w = q.W / length;
        }

        public double this[int row, int column] => ((row * 3) + column) switch
        {
            0 => 1 - (2 * ((_y * _y) + (_z * _z))),
            1 => 2 * ((_x * _y) - (_w * _z)),
            2 => 2 * ((_x * _z) + (_w * _y)),
            3 => 2 * ((_x * _y) + (_w * _z)),
            4 => 1 - (2 * ((_x * _x) + (_z * _z))),
            5 => 2 * ((_y * _z) - (_w * _x)),
            6 => 2 * ((_x * _z) - (_w * _y)),
            7 => 2 * ((_y * _z) + (_w * _x)),
            _ => 1 - (2 * ((_x * _x) + (_y * _y))),
        };
    }
}
