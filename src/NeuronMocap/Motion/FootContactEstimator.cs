using System.Numerics;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Motion;

/// <summary>
/// Estimates which feet stand on the ground, frame by frame, for live use. Does not allocate memory. Not thread-safe.
/// </summary>
/// <remarks>
/// The contacts of calculation data are used unchanged. Without them, contacts are estimated from the motion. For a complete take,
/// <see cref="FootContactTrack"/> is more accurate, because it knows the following frames.
/// </remarks>
public sealed class FootContactEstimator
{
    private readonly GroundEstimator _ground = new();

    private FootSample _before;
    private double _time = double.NaN;

    /// <summary>The feet that stood on the ground in the latest frame.</summary>
    public FootContacts Contacts { get; private set; }

    /// <summary>Updates the estimate with a pose.</summary>
    /// <param name="world">59 transforms in the world, in <see cref="Bone"/> order; centimetres, Y up.</param>
    /// <param name="body">The body, which defines where the feet end.</param>
    /// <param name="seconds">
    /// The time of the frame on any clock. A frame that is not later than the previous one, or whose time is not finite, does not change the
    /// estimate.
    /// </param>
    /// <param name="measured">
    /// The contacts that calculation data reports for this frame, if available: <c>CalculationFrame.FootContacts</c>.
    /// </param>
    /// <returns>The feet that stand on the ground.</returns>
    /// <exception cref="ArgumentException">There are fewer than 59 transforms.</exception>
    public FootContacts Update(ReadOnlySpan<BoneTransform> world, SkeletonBody body, double seconds, FootContacts? measured = null)
    {
        ArgumentNullException.ThrowIfNull(body);
        return Update(FootSample.Of(world, body), seconds, measured);
    }

    /// <summary>Updates the estimate with the positions of the feet, for example from converted calculation data.</summary>
    /// <param name="leftFoot">The middle of the left foot, in centimetres, Y up.</param>
    /// <param name="rightFoot">The middle of the right foot.</param>
    /// <param name="seconds">
    /// The time of the frame on any clock. A frame that is not later than the previous one, or whose time is not finite, does not change the
    /// estimate.
    /// </param>
    /// <param name="measured">The contacts that calculation data reports for this frame, if available.</param>
    /// <returns>The feet that stand on the ground.</returns>
    public FootContacts Update(Vector3 leftFoot, Vector3 rightFoot, double seconds, FootContacts? measured = null) =>
        Update(new FootSample(leftFoot, rightFoot), seconds, measured);

    /// <summary>Forgets all frames. Call this before measuring another actor, or when a take starts again.</summary>
    public void Reset()
    {
        _ground.Reset();
        _time = double.NaN;
        Contacts = default;
    }

    private FootContacts Update(in FootSample now, double seconds, FootContacts? measured)
    {
        if (!double.IsFinite(seconds))
            return Contacts = measured ?? Contacts;

        double elapsed = seconds - _time;
        float ground = _ground.Update(now.Lowest, seconds);
        if (measured is { } known)
            Contacts = known;
        else if (elapsed > 0 && now.IsFinite)
            Contacts = now.Touches(Contacts, _before, now, elapsed, ground);

        // Two frames with the same time do not define a speed. The next frame is compared with the first of them. A frame with values that are not numbers
        // tells nothing.
        if (elapsed is > 0 or double.NaN && now.IsFinite)
        {
            _before = now;
            _time = seconds;
        }

        return Contacts;
    }
}
