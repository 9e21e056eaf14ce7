using System.Numerics;

namespace NeuronMocap.Tests.Retargeting;

/// <summary>A 4x4 matrix on column vectors in double precision, for comparison with the library's quaternions and vectors.</summary>
internal sealed class Affine
{
    private readonly double[,] _cells;

    private Affine(double[,] cells) => _cells = cells;

    public static Affine Identity => Scaled(1, 1, 1);

    /// <summary>Mirrors X: converts from the library's axes to Unity's, and back.</summary>
    public static Affine MirrorX => Scaled(-1, 1, 1);

    public double this[int row, int column] => _cells[row, column];

    public static Affine Scaled(double x, double y, double z) =>
        new(new[,] { { x, 0, 0, 0 }, { 0, y, 0, 0 }, { 0, 0, z, 0 }, { 0, 0, 0, 1 } });

    public static Affine Scaled(Vector3 scale) => Scaled(scale.X, scale.Y, scale.Z);

    /// <summary>The signs of a scale.</summary>
    public static Affine Signs(Vector3 scale) => Scaled(scale.X < 0 ? -1 : 1, scale.Y < 0 ? -1 : 1, scale.Z < 0 ? -1 : 1);

    public static Affine Moved(double x, double y, double z) =>
        new(new[,] { { 1, 0, 0, x }, { 0, 1, 0, y }, { 0, 0, 1, z }, { 0, 0, 0, 1 } });

    public static Affine Moved(Vector3 way) => Moved(way.X, way.Y, way.Z);

    /// <summary>The rotation of a quaternion of any length. Each column is the image of a unit vector under q v q*.</summary>
    public static Affine Turned(Quaternion rotation)
    {
        (double x, double y, double z, double w) = (rotation.X, rotation.Y, rotation.Z, rotation.W);
        double norm = (x * x) + (y * y) + (z * z) + (w * w);
        return new Affine(new[,]
        {
            { ((w * w) + (x * x) - (y * y) - (z * z)) / norm, 2 * ((x * y) - (w * z)) / norm, 2 * ((x * z) + (w * y)) / norm, 0 },
            { 2 * ((x * y) + (w * z)) / norm, ((w * w) - (x * x) + (y * y) - (z * z)) / norm, 2 * ((y * z) - (w * x)) / norm, 0 },
            { 2 * ((x * z) - (w * y)) / norm, 2 * ((y * z) + (w * x)) / norm, ((w * w) - (x * x) - (y * y) + (z * z)) / norm, 0 },
            { 0, 0, 0, 1 },
        });
    }

    /// <summary>A rotation about an axis of length one, by Rodrigues' formula.</summary>
    public static Affine Turned(double[] axis, double angle)
    {
        (double sine, double cosine) = (Math.Sin(angle), Math.Cos(angle));
        double[,] cells = new double[4, 4];
        for (int row = 0; row < 3; row++)
        {
            for (int column = 0; column < 3; column++)
                cells[row, column] = (axis[row] * axis[column] * (1 - cosine)) + (row == column ? cosine : 0);
        }

        for (int i = 0; i < 3; i++)
        {
            cells[(i + 2) % 3, (i + 1) % 3] += axis[i] * sine;
            cells[(i + 1) % 3, (i + 2) % 3] -= axis[i] * sine;
        }

        cells[3, 3] = 1;
        return new Affine(cells);
    }

    public static Affine operator *(Affine a, Affine b)
    {
        (double[,] left, double[,] right) = (a._cells, b._cells);
        double[,] product = new double[4, 4];
        product[3, 3] = 1;
        for (int row = 0; row < 3; row++)
        {
            for (int column = 0; column < 4; column++)
            {
                product[row, column] = (left[row, 0] * right[0, column]) + (left[row, 1] * right[1, column])
                    + (left[row, 2] * right[2, column]) + (left[row, 3] * right[3, column]);
            }
        }

        return new Affine(product);
    }

    /// <summary>The inverse of a rotation.</summary>
    public Affine Back()
    {
        double[,] back = new double[4, 4];
        for (int row = 0; row < 4; row++)
        {
            for (int column = 0; column < 4; column++)
                back[row, column] = _cells[column, row];
        }

        return new Affine(back);
    }

    /// <summary>The inverse of anything, by elimination.</summary>
    public Affine Inverse()
    {
        double[,] left = (double[,])_cells.Clone();
        double[,] right = (double[,])Identity._cells.Clone();
        for (int pivot = 0; pivot < 4; pivot++)
        {
            int best = Enumerable.Range(pivot, 4 - pivot).MaxBy(row => Math.Abs(left[row, pivot]));
            for (int column = 0; column < 4; column++)
            {
                (left[pivot, column], left[best, column]) = (left[best, column], left[pivot, column]);
                (right[pivot, column], right[best, column]) = (right[best, column], right[pivot, column]);
            }

            double divisor = left[pivot, pivot];
            for (int column = 0; column < 4; column++)
            {
                left[pivot, column] /= divisor;
                right[pivot, column] /= divisor;
            }

            for (int row = 0; row < 4; row++)
            {
                double factor = left[row, pivot];
                for (int column = 0; column < 4 && row != pivot; column++)
                {
                    left[row, column] -= factor * left[pivot, column];
                    right[row, column] -= factor * right[pivot, column];
                }
            }
        }

        return new Affine(right);
    }

    /// <summary>The image of the origin.</summary>
    public double[] Place() => [_cells[0, 3], _cells[1, 3], _cells[2, 3]];

    /// <summary>The image of a point.</summary>
    public double[] Place(double[] point) => (this * Moved(point[0], point[1], point[2])).Place();

    /// <summary>The angle between two rotations, in radians. It is exact for small angles too.</summary>
    public double AngleTo(Affine other)
    {
        double sum = 0;
        for (int i = 0; i < 9; i++)
        {
            double difference = _cells[i / 3, i % 3] - other._cells[i / 3, i % 3];
            sum += difference * difference;
        }

        return 2 * Math.Asin(Math.Min(1, Math.Sqrt(sum / 8)));
    }

    public double AngleTo(Quaternion rotation) => AngleTo(Turned(rotation));

    /// <summary>A fraction of a rotation, along the shorter way.</summary>
    public Affine Part(double part)
    {
        double[] axis = [_cells[2, 1] - _cells[1, 2], _cells[0, 2] - _cells[2, 0], _cells[1, 0] - _cells[0, 1]];
        double length = Math.Sqrt(axis.Sum(component => component * component));
        double angle = Math.Atan2(length, _cells[0, 0] + _cells[1, 1] + _cells[2, 2] - 1);
        return length < 1e-12 ? Identity : Turned([.. axis.Select(component => component / length)], angle * part);
    }
}
