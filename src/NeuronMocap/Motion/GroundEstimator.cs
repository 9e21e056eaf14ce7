namespace NeuronMocap.Motion;

/// <summary>
/// Estimates the height of the ground under an actor from the lowest points of the body, frame by frame, for live use. Does not allocate memory.
/// Not thread-safe.
/// </summary>
/// <remarks>
/// The ground is never above the body. It follows the body down at once, and up at <see cref="MaxRise"/>. It therefore follows an actor up stairs
/// within a few steps, and hardly rises during a jump.
/// </remarks>
public sealed class GroundEstimator
{
    /// <summary>Maximum speed at which the ground rises, in centimetres per second: that of walking up stairs.</summary>
    public const float MaxRise = 30;

    private double _time = double.NaN;

    /// <summary>The height in the latest frame, in centimetres along Y; NaN before the first frame.</summary>
    public float Height { get; private set; } = float.NaN;

    /// <summary>The lowest point of all frames, in centimetres: the ground of a take on one level; NaN before the first frame.</summary>
    public float Lowest { get; private set; } = float.NaN;

    /// <summary>Updates the estimate with a frame. A frame whose height or time is not finite is ignored.</summary>
    /// <param name="lowest">The lowest point of the body, in centimetres: <see cref="Skeleton.JointPositions.GetLowest"/>.</param>
    /// <param name="seconds">The time of the frame on any clock.</param>
    /// <returns>The height of the ground.</returns>
    public float Update(float lowest, double seconds)
    {
        if (!float.IsFinite(lowest) || !double.IsFinite(seconds))
            return Height;

        double elapsed = Math.Max(0, seconds - _time);
        Height = double.IsNaN(_time) ? lowest : Math.Min(lowest, Height + (float)(elapsed * MaxRise));
        Lowest = float.IsNaN(Lowest) ? lowest : Math.Min(Lowest, lowest);
        _time = seconds;
        return Height;
    }

    /// <summary>Forgets all frames.</summary>
    public void Reset()
    {
        _time = double.NaN;
        Height = float.NaN;
        Lowest = float.NaN;
    }
}
