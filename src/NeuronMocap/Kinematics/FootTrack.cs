using NeuronMocap.Skeleton;

namespace NeuronMocap.Kinematics;

/// <summary>
/// The way of the feet through a take, from which their contacts with the ground follow when all of it is known. Not thread-safe.
/// </summary>
/// <param name="body">Whose feet they are.</param>
public sealed class FootTrack(SkeletonBody body)
{
    private readonly SkeletonBody _body = body ?? throw new ArgumentNullException(nameof(body));
    private readonly List<FootSample> _samples = [];
    private readonly List<double> _times = [];

    /// <summary>Adds the next frame of the take.</summary>
    /// <param name="world">59 transforms in the world, in <see cref="Bone"/> order; centimetres.</param>
    /// <param name="seconds">When it was, on any clock; later than the frame before.</param>
    /// <exception cref="ArgumentException">There are fewer than 59 transforms.</exception>
    public void Add(ReadOnlySpan<BoneTransform> world, double seconds)
    {
        _samples.Add(new FootSample(world, _body));
        _times.Add(seconds);
    }

    /// <summary>Estimates for every frame which feet stand on the ground.</summary>
    /// <returns>As many as frames were added, in their order.</returns>
    public FootContacts[] EstimateContacts()
    {
        var contacts = new FootContacts[_samples.Count];
        if (contacts.Length == 0)
            return contacts;

        float ground = _samples.Min(static sample => sample.Lowest);
        for (int i = 0; i < contacts.Length; i++)
        {
            int before = Math.Max(0, i - 1);
            int after = Math.Min(contacts.Length - 1, i + 1);
            contacts[i] = _samples[i].Touches(
                i > 0 ? contacts[i - 1] : default, _samples[before], _samples[after], _times[after] - _times[before], ground);
        }

        return contacts;
    }
}
