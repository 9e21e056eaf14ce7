namespace NeuronMocap.Motion;

/// <summary>
/// How high the ground is under an actor, from the lowest points of the body, frame by frame: for live use. It is never above
/// the body, follows it down at once, and up at <see cref="MaxRise"/>: up stairs within a few steps, and hardly in a jump. Allocates nothing. Not thread-safe.
/// </summary>
public sealed class GroundEstimator
{
    /// <summary>How fast the ground may come up, in centimetres per second: that of stairs.</summary>
    public const float MaxRise = 30;

    private double _time = double.NaN;

    /// <summary>The height in the newest frame, in centimetres, along Y; NaN before the first.</summary>
    public float Height { get; private set; } = float.NaN;

    /// <summary>The lowest point of all frames, in centimetres: the ground of a take on one level; NaN before the first.</summary>
    public float Lowest { get; private set; } = float.NaN;

    /// <summary>Takes a frame. One whose height or time is not a finite number is left out.</summary>
    /// <param name="lowest">The lowest point of the body, in centimetres: <see cref="Skeleton.JointPositions.GetLowest"/>.</param>
    /// <param name="seconds">When, on any clock.</param>
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

    /// <summary>Begins again.</summary>
    public void Reset()
    {
        _time = double.NaN;
        Height = float.NaN;
        Lowest = float.NaN;
    }
}
