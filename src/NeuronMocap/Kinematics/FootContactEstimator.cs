using NeuronMocap.Skeleton;

namespace NeuronMocap.Kinematics;

/// <summary>
/// Finds out which feet stand on the ground, from the motion alone, frame by frame: for live use. For a whole take, <see cref="FootTrack"/> knows more.
/// Allocates nothing. Not thread-safe.
/// </summary>
/// <param name="body">Whose feet they are.</param>
public sealed class FootContactEstimator(SkeletonBody body)
{
    private readonly SkeletonBody _body = body ?? throw new ArgumentNullException(nameof(body));

    private FootSample _before;
    private double _time = double.NaN;
    private float _ground = float.PositiveInfinity;

    /// <summary>Which feet stood on the ground in the newest frame.</summary>
    public FootContacts Contacts { get; private set; }

    /// <summary>Takes a frame.</summary>
    /// <param name="world">59 transforms in the world, in <see cref="Bone"/> order; centimetres.</param>
    /// <param name="seconds">When it was, on any clock; later than the frame before.</param>
    /// <param name="measured">What calculation data says about this frame, where there is any: it is taken as it is.</param>
    /// <returns>Which feet stand on the ground.</returns>
    /// <exception cref="ArgumentException">There are fewer than 59 transforms.</exception>
    public FootContacts Update(ReadOnlySpan<BoneTransform> world, double seconds, FootContacts? measured = null)
    {
        var now = new FootSample(world, _body);
        double elapsed = seconds - _time;
        _ground = Math.Min(_ground, now.Lowest);
        if (measured is { } known)
            Contacts = known;
        else if (elapsed > 0)
            Contacts = now.Touches(Contacts, _before, now, elapsed, _ground);

        _before = now;
        _time = seconds;
        return Contacts;
    }

    /// <summary>Forgets all frames: before another actor, or a take that starts over.</summary>
    public void Reset()
    {
        _time = double.NaN;
        _ground = float.PositiveInfinity;
        Contacts = default;
    }
}
