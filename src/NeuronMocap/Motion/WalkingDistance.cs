using System.Numerics;

namespace NeuronMocap.Motion;

/// <summary>
/// Measures how far and how fast an actor has walked, from the path of the hips over the ground. Does not allocate memory. Not thread-safe.
/// </summary>
/// <remarks>
/// A point follows the hips as if pulled by a rope of length <see cref="Slack"/>. It stays while the hips only sway, and follows when they move
/// away. The length of its path is the distance. Standing still does not count as walking, and neither do noise or the sway of each step. A curve
/// is measured less than one percent too short if its radius is at least seven times the slack.
/// </remarks>
public sealed class WalkingDistance
{
    // The speed is a mean over about this time, with less weight on earlier frames.
    private const double SpeedSeconds = 0.5;

    private Vector2 _follower;
    private double _time = double.NaN;

    /// <summary>Creates a measurement that begins with the first frame.</summary>
    /// <param name="slack">How far the hips may move without walking, in centimetres. The measured distance is too short by this length.</param>
    /// <exception cref="ArgumentOutOfRangeException">The slack is not a positive number.</exception>
    public WalkingDistance(float slack = 10)
    {
        if (!(slack > 0) || float.IsInfinity(slack))
            throw new ArgumentOutOfRangeException(nameof(slack), slack, "The slack must be a positive number, in centimetres.");

        Slack = slack;
    }

    /// <summary>Length of the rope, in centimetres.</summary>
    public float Slack { get; }

    /// <summary>The distance so far, in centimetres.</summary>
    public double Distance { get; private set; }

    /// <summary>Speed over the ground in about the last half second, in centimetres per second; 0 when standing.</summary>
    public double Speed { get; private set; }

    /// <summary>
    /// Updates the measurement with a frame. A frame is ignored if its position or time is not finite, or if it is not later than the previous one.
    /// </summary>
    /// <param name="hips">Position of the hips in the world, in centimetres, Y up.</param>
    /// <param name="seconds">The time of the frame on any clock.</param>
    public void Update(Vector3 hips, double seconds)
    {
        var place = new Vector2(hips.X, hips.Z);
        if (!float.IsFinite(place.LengthSquared()) || !double.IsFinite(seconds))
            return;

        double elapsed = seconds - _time;
        if (double.IsNaN(_time))
            _follower = place;
        else if (elapsed > 0)
            Follow(place, elapsed);
        else
            return;

        _time = seconds;
    }

    /// <summary>Starts again. Call this before measuring another actor, or when an actor was placed elsewhere.</summary>
    public void Reset()
    {
        _time = double.NaN;
        Distance = 0;
        Speed = 0;
    }

    private void Follow(Vector2 place, double elapsed)
    {
        Vector2 rope = place - _follower;
        float length = rope.Length();
        float step = Math.Max(0, length - Slack);
        if (step > 0)
            _follower += rope * (step / length);

        Distance += step;
        Speed += (1 - Math.Exp(-elapsed / SpeedSeconds)) * ((step / elapsed) - Speed);
    }
}
