using System.Numerics;

namespace NeuronMocap.Motion;

/// <summary>
/// How far somebody has walked, and how fast, from the way of the hips over the ground. A point follows the hips as if on a rope of
/// <see cref="Slack"/>: it stays where it is as long as they only sway, and is dragged behind them when they leave. Its way is the distance.
/// So standing still for any time walks nothing, noise and the sway of each step add nothing, and a curve comes out shorter
/// by less than one percent where its radius is seven times the slack or more. Allocates nothing. Not thread-safe.
/// </summary>
public sealed class WalkingDistance
{
    // The speed is the mean of about this time, with less weight for what is long ago.
    private const double SpeedSeconds = 0.5;

    private Vector2 _follower;
    private double _time = double.NaN;

    /// <summary>Makes a measurement that begins with the first frame.</summary>
    /// <param name="slack">How far the hips may be away from where they were without having walked, in centimetres. The distance is short by one slack.</param>
    /// <exception cref="ArgumentOutOfRangeException">The slack is not a positive number.</exception>
    public WalkingDistance(float slack = 10)
    {
        if (!(slack > 0) || float.IsInfinity(slack))
            throw new ArgumentOutOfRangeException(nameof(slack), slack, "The slack must be a positive number of centimetres.");

        Slack = slack;
    }

    /// <summary>Length of the rope, in centimetres.</summary>
    public float Slack { get; }

    /// <summary>The way so far, in centimetres.</summary>
    public double Distance { get; private set; }

    /// <summary>Speed over the ground in about the last half second, in centimetres per second; 0 for who stands.</summary>
    public double Speed { get; private set; }

    /// <summary>Takes a frame. One whose position or time is not a finite number, or which is no later than the one before, is left out.</summary>
    /// <param name="hips">Where the hips are in the world, in centimetres, Y up.</param>
    /// <param name="seconds">When, on any clock.</param>
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

    /// <summary>Begins again: before another actor, or when one was put somewhere else.</summary>
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
