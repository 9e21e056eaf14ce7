using System.Numerics;
using NeuronMocap.Bvh;
using NeuronMocap.Tool.Figures;

namespace NeuronMocap.Tool.Info;

/// <summary>Gets the values of a frame.</summary>
internal delegate ReadOnlySpan<float> RowReader(int frame);

/// <summary>Finds anomalies in the rows of a take.</summary>
/// <remarks>
/// <list type="bullet">
/// <item>values that are not finite numbers</item>
/// <item>columns that never change</item>
/// <item>flips: neighbouring frames with nearly the same rotation but very different angles</item>
/// <item>a first frame in the rest pose, followed by a jump</item>
/// </list>
/// </remarks>
internal sealed class RowScan
{
    private const float Flip = 90;
    private const float SameRotation = 30;
    private const float AtRest = 0.5f;
    private const float Jump = 20;

    private readonly BvhJoint[] _joints;
    private readonly Quaternion[] _before;
    private readonly float[] _first;
    private readonly bool[] _changes;
    private readonly int[] _flips;

    private RowScan(IEnumerable<BvhJoint> joints, int channels)
    {
        _joints = [.. joints];
        _before = new Quaternion[_joints.Length];
        _first = new float[channels];
        _changes = new bool[channels];
        _flips = new int[_joints.Length];
    }

    /// <summary>Number of values that are not finite.</summary>
    public long NotNumbers { get; private set; }

    /// <summary>The first frame with a value that is not finite.</summary>
    public int FirstNotNumber { get; private set; } = -1;

    /// <summary>Number of columns with the same value in every frame.</summary>
    public int ConstantColumns => _changes.Count(static changes => !changes);

    /// <summary>
    /// Number of flips. In a flip, the angles of a joint change by more than 90 degrees from one frame to the next. Its rotation changes by less than 30.
    /// </summary>
    public long Flips => _flips.Sum(static count => (long)count);

    /// <summary>The frame after the first flip.</summary>
    public int FirstFlip { get; private set; } = -1;

    /// <summary>Joints with flips, in descending order of their number.</summary>
    public IEnumerable<(BvhJoint Joint, int Count)> FlippingJoints =>
        _joints.Zip(_flips).Where(static pair => pair.Second > 0).OrderByDescending(static pair => pair.Second);

    /// <summary>The largest rotation of a joint from one frame to the next, in degrees, with its joint and frame.</summary>
    public (float Degrees, BvhJoint? Joint, int Frame) LargestStep { get; private set; }

    /// <summary>Whether all joints are unrotated in the first frame but not in the second.</summary>
    public bool StartsAtRest { get; private set; }

    /// <summary>Scans all rows.</summary>
    public static RowScan Run(IEnumerable<BvhJoint> joints, int channels, int frames, RowReader rows, CancellationToken cancellationToken)
    {
        var scan = new RowScan(joints, channels);
        bool restFirst = false;
        for (int frame = 0; frame < frames; frame++)
        {
            cancellationToken.ThrowIfCancellationRequested();
            float turned = scan.Take(frame, rows(frame), frame > 0 ? rows(frame - 1) : default);
            if (frame == 0)
                restFirst = scan.IsAtRest();
            else if (frame == 1)
                scan.StartsAtRest = restFirst && turned > Jump;
        }

        return scan;
    }

    // Returns the largest rotation since the previous frame.
    private float Take(int frame, ReadOnlySpan<float> row, ReadOnlySpan<float> before)
    {
        TakeValues(frame, row);
        float largest = 0;
        for (int i = 0; i < _joints.Length; i++)
        {
            Quaternion rotation = BvhRotations.Get(_joints[i], row);
            float turned = frame == 0 ? 0 : AngleBetween(_before[i], rotation);
            _before[i] = rotation;
            if (!(turned >= 0) || frame == 0)
                continue;

            largest = Math.Max(largest, turned);
            if (turned > LargestStep.Degrees)
                LargestStep = (turned, _joints[i], frame);
            if (turned < SameRotation && BvhRotations.LargestDifference(_joints[i], before, row) > Flip)
            {
                _flips[i]++;
                FirstFlip = FirstFlip < 0 ? frame : FirstFlip;
            }
        }

        return largest;
    }

    private void TakeValues(int frame, ReadOnlySpan<float> row)
    {
        if (frame == 0)
            row.CopyTo(_first);

        for (int column = 0; column < row.Length; column++)
        {
            // Minus zero equals zero. Axis Neuron writes both.
            if (row[column] != _first[column])
                _changes[column] = true;
            if (float.IsFinite(row[column]))
                continue;

            NotNumbers++;
            FirstNotNumber = FirstNotNumber < 0 ? frame : FirstNotNumber;
        }
    }

    private bool IsAtRest() => _before.Skip(1).All(static rotation => AngleBetween(rotation, Quaternion.Identity) < AtRest);

    private static float AngleBetween(Quaternion a, Quaternion b) =>
        2 * MathF.Acos(Math.Min(1, MathF.Abs(Quaternion.Dot(a, b)))) * (180 / MathF.PI);
}
