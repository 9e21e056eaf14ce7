using System.Numerics;

namespace NeuronMocap.Calculation;

/// <summary>
/// Finds the first joint of a chain of bones on the trunk from the motion of the bones.
/// </summary>
/// <remarks>
/// <para>
/// A joint is fixed in the sensor axes of both of its bones. The centre of a bone is the midpoint of its two joints. In every frame, the vector
/// from one bone's centre to the next is therefore R1 a + R2 b. Each bone has one constant vector, which is unknown; together they form a linear
/// least-squares problem.
/// </para>
/// <para>
/// A joint that hardly moves, such as that of a shoulder blade, is therefore found from the moving joints beyond it. If nothing moves, a guess
/// decides.
/// </para>
/// </remarks>
/// <param name="boneCount">Number of bones, including that of the trunk; at least 2.</param>
internal sealed class ChainFit(int boneCount)
{
    // The guess has the weight of a motion of 0.14 radians.
    private const double GuessWeight = 0.02;

    private readonly int _unknowns = 3 * boneCount;
    private readonly double[,] _normal = new double[3 * boneCount, (3 * boneCount) + 1];
    private Vector3 _guess;
    private int _count;

    /// <summary>Adds a frame.</summary>
    /// <param name="rotations">Rotations of the bones' sensors, starting with the trunk.</param>
    /// <param name="centres">The centres of the bones. For the trunk, any point that moves with it.</param>
    /// <param name="guess">The assumed vector from the trunk's point to the first joint.</param>
    public void Add(ReadOnlySpan<Quaternion> rotations, ReadOnlySpan<Vector3> centres, Vector3 guess)
    {
        Span<Vector3> columns = stackalloc Vector3[6];
        for (int bone = 0; bone + 1 < boneCount; bone++)
        {
            for (int i = 0; i < columns.Length; i++)
                columns[i] = Axis(rotations[bone + (i / 3)], i % 3);

            AddJoint(3 * bone, columns, centres[bone + 1] - centres[bone]);
        }

        _guess += Vector3.Transform(guess, Quaternion.Conjugate(rotations[0]));
        _count++;
    }

    /// <summary>Computes the position of the first joint, relative to the trunk's point, in the axes of the trunk's sensor.</summary>
    public Vector3 Solve()
    {
        for (int i = 0; i < 3; i++)
        {
            _normal[i, i] += GuessWeight * _count;
            _normal[i, _unknowns] += GuessWeight * (i == 0 ? _guess.X : i == 1 ? _guess.Y : _guess.Z);
        }

        Eliminate();
        return new Vector3((float)_normal[0, _unknowns], (float)_normal[1, _unknowns], (float)_normal[2, _unknowns]);
    }

    private static Vector3 Axis(Quaternion rotation, int axis) =>
        Vector3.Transform(axis == 0 ? Vector3.UnitX : axis == 1 ? Vector3.UnitY : Vector3.UnitZ, rotation);

    private void AddJoint(int first, ReadOnlySpan<Vector3> columns, Vector3 way)
    {
        for (int row = 0; row < columns.Length; row++)
        {
            for (int column = 0; column < columns.Length; column++)
                _normal[first + row, first + column] += Vector3.Dot(columns[row], columns[column]);

            _normal[first + row, _unknowns] += Vector3.Dot(columns[row], way);
        }
    }

    // Gauss-Jordan elimination. The matrix is symmetric and, with the guess, positive definite; every pivot is therefore different from zero.
    private void Eliminate()
    {
        for (int pivot = 0; pivot < _unknowns; pivot++)
        {
            for (int column = _unknowns; column >= pivot; column--)
                _normal[pivot, column] /= _normal[pivot, pivot];

            for (int row = 0; row < _unknowns; row++)
            {
                double factor = row == pivot ? 0 : _normal[row, pivot];
                for (int column = pivot; column <= _unknowns; column++)
                    _normal[row, column] -= factor * _normal[pivot, column];
            }
        }
    }
}
