using System.Numerics;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Motion;

/// <summary>
/// Which feet stand on the ground, frame by frame: for live use. What calculation data says is taken as it is; where there is none, it is
/// estimated from the motion. For a whole take, <see cref="FootTrack"/> knows more: it sees what comes. Allocates nothing. Not thread-safe.
/// </summary>
public sealed class FootContactEstimator
{
    private readonly GroundHeight _ground = new();

    private FootSample _before;
    private double _time = double.NaN;

    /// <summary>Which feet stood on the ground in the newest frame.</summary>
    public FootContacts Contacts { get; private set; }

    /// <summary>Takes a frame of a pose.</summary>
    /// <param name="world">59 transforms in the world, in <see cref="Bone"/> order; centimetres, Y up.</param>
    /// <param name="body">Says where the feet end.</param>
    /// <param name="seconds">When it was, on any clock. A frame no later than the one before leaves the estimate as it was.</param>
    /// <param name="measured">What calculation data says about this frame, where there is any: <c>CalculationFrame.FootContacts</c>.</param>
    /// <returns>Which feet stand on the ground.</returns>
    /// <exception cref="ArgumentException">There are fewer than 59 transforms.</exception>
    public FootContacts Update(ReadOnlySpan<BoneTransform> world, SkeletonBody body, double seconds, FootContacts? measured = null)
    {
        ArgumentNullException.ThrowIfNull(body);
        return Update(FootSample.Of(world, body), seconds, measured);
    }

    /// <summary>Takes a frame of which the feet are known, as calculation data of any axes and units has them once they are converted.</summary>
    /// <param name="leftFoot">The middle of the left foot, in centimetres, Y up.</param>
    /// <param name="rightFoot">The middle of the right foot.</param>
    /// <param name="seconds">When it was, on any clock. A frame no later than the one before leaves the estimate as it was.</param>
    /// <param name="measured">What calculation data says about this frame, where there is any.</param>
    /// <returns>Which feet stand on the ground.</returns>
    public FootContacts Update(Vector3 leftFoot, Vector3 rightFoot, double seconds, FootContacts? measured = null) =>
        Update(new FootSample(leftFoot, rightFoot), seconds, measured);

    /// <summary>Forgets all frames: before another actor, or a take that starts over.</summary>
    public void Reset()
    {
        _ground.Reset();
        _time = double.NaN;
        Contacts = default;
    }

    private FootContacts Update(in FootSample now, double seconds, FootContacts? measured)
    {
        double elapsed = seconds - _time;
        float ground = _ground.Update(now.Lowest, seconds);
        if (measured is { } known)
            Contacts = known;
        else if (elapsed > 0)
            Contacts = now.Touches(Contacts, _before, now, elapsed, ground);

        // Two frames that came at once have no speed between them; the next one is compared with the first.
        if (elapsed is > 0 or double.NaN)
        {
            _before = now;
            _time = seconds;
        }

        return Contacts;
    }
}
