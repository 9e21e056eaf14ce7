using System.Numerics;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Motion;

/// <summary>
/// The way of the feet through a take, from which their contacts with the ground follow when all of it is known. Not thread-safe.
/// </summary>
public sealed class FootTrack
{
    private readonly List<FootSample> _samples = [];
    private readonly List<double> _times = [];

    /// <summary>Adds the next frame of the take.</summary>
    /// <param name="world">59 transforms in the world, in <see cref="Bone"/> order; centimetres, Y up.</param>
    /// <param name="body">Says where the feet end.</param>
    /// <param name="seconds">When it was, on any clock; later than the frame before.</param>
    /// <exception cref="ArgumentException">There are fewer than 59 transforms.</exception>
    public void Add(ReadOnlySpan<BoneTransform> world, SkeletonBody body, double seconds)
    {
        ArgumentNullException.ThrowIfNull(body);
        Add(FootSample.Of(world, body), seconds);
    }

    /// <summary>Adds the next frame of a take of which the feet are known, as calculation data has them once it is converted.</summary>
    /// <param name="leftFoot">The middle of the left foot, in centimetres, Y up.</param>
    /// <param name="rightFoot">The middle of the right foot.</param>
    /// <param name="seconds">When it was, on any clock; later than the frame before.</param>
    public void Add(Vector3 leftFoot, Vector3 rightFoot, double seconds) => Add(new FootSample(leftFoot, rightFoot), seconds);

    /// <summary>Estimates for every frame which feet stand on the ground.</summary>
    /// <returns>As many as frames were added, in their order.</returns>
    public FootContacts[] EstimateContacts()
    {
        float[] ground = EstimateGround();
        var contacts = new FootContacts[_samples.Count];
        FootContacts last = default;
        for (int i = 0; i < contacts.Length; i++)
        {
            int before = Math.Max(0, i - 1);
            int after = Math.Min(contacts.Length - 1, i + 1);
            last = _samples[i].Touches(last, _samples[before], _samples[after], _times[after] - _times[before], ground[i]);
            contacts[i] = last;
        }

        return contacts;
    }

    // As GroundHeight does, from both ends: a step up is known before it comes.
    private float[] EstimateGround()
    {
        float[] heights = [.. _samples.Select(static sample => sample.Lowest)];
        var forward = new GroundHeight();
        var backward = new GroundHeight();
        for (int i = 0; i < heights.Length; i++)
            heights[i] = forward.Update(heights[i], _times[i]);
        for (int i = heights.Length - 1; i >= 0; i--)
            heights[i] = backward.Update(heights[i], -_times[i]);

        return heights;
    }

    private void Add(in FootSample sample, double seconds)
    {
        _samples.Add(sample);
        _times.Add(seconds);
    }
}
