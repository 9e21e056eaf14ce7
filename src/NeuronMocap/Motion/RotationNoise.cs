using System.Numerics;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Motion;

/// <summary>
/// Measures how much the rotations of bones tremble from frame to frame, for example before and after smoothing. Does not allocate memory after the
/// constructor. Not thread-safe.
/// </summary>
/// <remarks>
/// A rotation is compared with the line through its two neighbours. Motion at a steady speed therefore does not count as noise, at any spacing of the
/// frames.
/// </remarks>
public sealed class RotationNoise
{
    // The result is a mean over about this time, with less weight on earlier frames.
    private const double MeanSeconds = 1;

    // Beyond these, the three frames do not belong to one motion.
    private const double LongestInterval = 0.5;
    private const double LargestRatio = 8;

    private readonly Quaternion[] _last = new Quaternion[BoneHierarchy.BoneCount];
    private readonly Vector3[] _lastTurns = new Vector3[BoneHierarchy.BoneCount];
    private readonly double[] _meanSquares = new double[BoneHierarchy.BoneCount];
    private double _time = double.NaN;
    private double _lastElapsed = double.NaN;

    /// <summary>Adds a frame. A frame with the time of the previous one is ignored.</summary>
    /// <param name="pose">59 transforms relative to their parents, in <see cref="Bone"/> order.</param>
    /// <param name="seconds">The time of the frame on any clock.</param>
    /// <exception cref="ArgumentException">There are fewer than 59 transforms.</exception>
    public void Update(ReadOnlySpan<BoneTransform> pose, double seconds)
    {
        ForwardKinematics.CheckPose(pose, nameof(pose));
        double elapsed = seconds - _time;
        if (elapsed == 0)
            return;

        bool continues = elapsed > 0 && elapsed <= LongestInterval;
        double ratio = elapsed / _lastElapsed;
        bool isKnown = continues && ratio > 1 / LargestRatio && ratio < LargestRatio;

        // The variance of the difference below, for rotations whose noise has the variance 1.
        double variance = 1 + (ratio * ratio) + ((1 + ratio) * (1 + ratio));
        double share = 1 - Math.Exp(-elapsed / MeanSeconds);
        for (int bone = 0; bone < BoneHierarchy.BoneCount; bone++)
        {
            Vector3 turn = continues ? QuaternionMath.TurnBetween(_last[bone], pose[bone].Rotation) : Vector3.Zero;
            double square = (turn - (_lastTurns[bone] * (float)ratio)).LengthSquared() / variance;
            if (isKnown && double.IsFinite(square))
                _meanSquares[bone] += share * (square - _meanSquares[bone]);

            _last[bone] = pose[bone].Rotation;
            _lastTurns[bone] = turn;
        }

        _time = seconds;
        _lastElapsed = continues ? elapsed : double.NaN;
    }

    /// <summary>Gets the noise of a bone in about the last second.</summary>
    /// <param name="bone">The bone.</param>
    /// <returns>The standard deviation of the angle, in degrees, if the noise of each frame is independent.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The bone is not defined.</exception>
    public double GetDegrees(Bone bone) => Math.Sqrt(_meanSquares[BoneHierarchy.CheckedIndex(bone)]) * 180 / Math.PI;

    /// <summary>Forgets all frames.</summary>
    public void Reset()
    {
        _time = _lastElapsed = double.NaN;
        Array.Clear(_meanSquares, 0, _meanSquares.Length);
    }
}
