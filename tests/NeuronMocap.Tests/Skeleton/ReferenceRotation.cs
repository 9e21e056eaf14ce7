using System.Numerics;

namespace NeuronMocap.Tests.Skeleton;

/// <summary>Rotations as plain 3x3 matrices on column vectors, in double precision, for comparison with the library's quaternions.</summary>
internal sealed class ReferenceRotation
{
    private readonly double[,] _rows;

    private ReferenceRotation(double[,] rows) => _rows = rows;

    /// <summary>R = R_first * R_second * R_third, with the axes from the letters of the order's name.</summary>
    public static ReferenceRotation FromAngles(Vector3 degrees, RotationOrder order)
    {
        string axes = order.ToString();
        return About(axes[0], degrees.X).Times(About(axes[1], degrees.Y)).Times(About(axes[2], degrees.Z));
    }

    /// <summary>The columns are the images of the unit vectors under q v q*.</summary>
    public static ReferenceRotation FromQuaternion(Quaternion rotation)
    {
        double[] q = [rotation.W, rotation.X, rotation.Y, rotation.Z];
        double length = Math.Sqrt(q.Sum(part => part * part));
        q = [.. q.Select(part => part / length)];
        double[] conjugate = [q[0], -q[1], -q[2], -q[3]];
        double[,] rows = new double[3, 3];
        for (int column = 0; column < 3; column++)
        {
            double[] unit = [0, 0, 0, 0];
            unit[column + 1] = 1;
            double[] turned = Product(Product(q, unit), conjugate);
            for (int row = 0; row < 3; row++)
                rows[row, column] = turned[row + 1];
        }

        return new ReferenceRotation(rows);
    }

    public ReferenceRotation Times(ReferenceRotation other)
    {
        double[,] product = new double[3, 3];
        for (int row = 0; row < 3; row++)
        {
            for (int column = 0; column < 3; column++)
            {
                for (int i = 0; i < 3; i++)
                    product[row, column] += _rows[row, i] * other._rows[i, column];
            }
        }

        return new ReferenceRotation(product);
    }

    public double[] Turn(double[] vector) =>
        [.. Enumerable.Range(0, 3).Select(row => (_rows[row, 0] * vector[0]) + (_rows[row, 1] * vector[1]) + (_rows[row, 2] * vector[2]))];

    /// <summary>The largest difference between two entries.</summary>
    public double Distance(ReferenceRotation other) => Enumerable.Range(0, 9).Max(i => Math.Abs(_rows[i / 3, i % 3] - other._rows[i / 3, i % 3]));

    public double Distance(Quaternion rotation) => Distance(FromQuaternion(rotation));

    private static ReferenceRotation About(char axis, double degrees)
    {
        double sine = Math.Sin(degrees * Math.PI / 180);
        double cosine = Math.Cos(degrees * Math.PI / 180);
        return new ReferenceRotation(axis switch
        {
            'X' => new[,] { { 1, 0, 0 }, { 0, cosine, -sine }, { 0, sine, cosine } },
            'Y' => new[,] { { cosine, 0, sine }, { 0, 1, 0 }, { -sine, 0, cosine } },
            _ => new[,] { { cosine, -sine, 0 }, { sine, cosine, 0 }, { 0, 0, 1 } },
        });
    }

    private static double[] Product(double[] a, double[] b) =>
    [
        (a[0] * b[0]) - (a[1] * b[1]) - (a[2] * b[2]) - (a[3] * b[3]),
        (a[0] * b[1]) + (a[1] * b[0]) + (a[2] * b[3]) - (a[3] * b[2]),
        (a[0] * b[2]) - (a[1] * b[3]) + (a[2] * b[0]) + (a[3] * b[1]),
        (a[0] * b[3]) + (a[1] * b[2]) - (a[2] * b[1]) + (a[3] * b[0]),
    ];
}
