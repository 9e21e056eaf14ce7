using System.Numerics;

namespace NeuronMocap.Calculation;

/// <summary>
/// Finds the joint between two bones from how they move: the point that stays where it is in both of their sensors' axes. For every frame the
/// way between the bones' centres is R1 a + R2 b with constant a and b, six unknowns of a linear least-squares problem. Where the bones did
/// not move against each other, a guess decides.
/// </summary>
internal sealed class JointFit
{
    private const int Unknowns = 6;

    // The guess counts as much as a motion of 0.1 radians would.
    private const double GuessWeight = 0.01;

    private readonly double[,] _normal = new double[Unknowns, Unknowns + 1];
    private Vector3 _guessFirst;
    private Vector3 _guessSecond;
    private int _count;

    /// <summary>Adds a frame.</summary>
    /// <param name="first">Rotation of the first bone's sensor.</param>
    /// <param name="second">Rotation of the second bone's sensor.</param>
    /// <param name="way">From the first bone's centre to the second's.</param>
    /// <param name="guess">From the first bone's centre to where the joint may be.</param>
    public void Add(Quaternion first, Quaternion second, Vector3 way, Vector3 guess)
    {
        Span<Vector3> columns =
        [
            Vector3.Transform(Vector3.UnitX, first), Vector3.Transform(Vector3.UnitY, first), Vector3.Transform(Vector3.UnitZ, first),
            Vector3.Transform(Vector3.UnitX, second), Vector3.Transform(Vector3.UnitY, second), Vector3.Transform(Vector3.UnitZ, second),
        ];
        for (int row = 0; row < Unknowns; row++)
        {
            for (int column = 0; column < Unknowns; column++)
                _normal[row, column] += Vector3.Dot(columns[row], columns[column]);

            _normal[row, Unknowns] += Vector3.Dot(columns[row], way);
        }

        _guessFirst += Vector3.Transform(guess, Quaternion.Conjugate(first));
        _guessSecond += Vector3.Transform(way - guess, Quaternion.Conjugate(second));
        _count++;
    }

    /// <summary>The joint, from the first bone's centre, in its sensor's axes.</summary>
    public Vector3 Solve()
    {
        Span<float> guess =
        [
            _guessFirst.X, _guessFirst.Y, _guessFirst.Z, _guessSecond.X, _guessSecond.Y, _guessSecond.Z,
        ];
        for (int i = 0; i < Unknowns; i++)
        {
            _normal[i, i] += GuessWeight * _count;
            _normal[i, Unknowns] += GuessWeight * guess[i];
        }

        Eliminate();
        return new Vector3((float)_normal[0, Unknowns], (float)_normal[1, Unknowns], (float)_normal[2, Unknowns]);
    }

    // Gauss and Jordan; the matrix is symmetric and, with the guess, positive definite, so that no pivot is zero.
    private void Eliminate()
    {
        for (int pivot = 0; pivot < Unknowns; pivot++)
        {
            for (int column = Unknowns; column >= pivot; column--)
                _normal[pivot, column] /= _normal[pivot, pivot];

            for (int row = 0; row < Unknowns; row++)
            {
                double factor = row == pivot ? 0 : _normal[row, pivot];
                for (int column = pivot; column <= Unknowns; column++)
                    _normal[row, column] -= factor * _normal[pivot, column];
            }
        }
    }
}
