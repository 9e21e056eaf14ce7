using System.Numerics;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Motion;

/// <summary>
/// Collects the motion of the feet in a complete take and estimates their contacts with the ground. Not thread-safe.
/// </summary>
public sealed class FootContactTrack
{
    private readonly List<FootSample> _samples = [];
    private readonly List<double> _times = [];

    /// <summary>Adds the next frame of the take.</summary>
    /// <param name="world">59 transforms in the world, in <see cref="Bone"/> order; centimetres, Y up.</param>
    /// <param name="body">The body, which defines where the feet end.</param>
    /// <param name="seconds">The time of the frame on any clock, later than the previous one.</param>
    /// <exception cref="ArgumentException">There are fewer than 59 transforms.</exception>
    public void Add(ReadOnlySpan<BoneTransform> world, SkeletonBody body, double seconds)
    {
        ArgumentNullException.ThrowIfNull(body);
        Add(FootSample.Of(world, body), seconds);
    }

    /// <summary>Adds the positions of the feet in the next frame, for example from converted calculation data.</summary>
    /// <param name="leftFoot">The middle of the left foot, in centimetres, Y up.</param>
    /// <param name="rightFoot">The middle of the right foot.</param>
    /// <param name="seconds">The time of the frame on any clock, later than the previous one.</param>
    public void Add(Vector3 leftFoot, Vector3 rightFoot, double seconds) => Add(new FootSample(leftFoot, rightFoot), seconds);

    /// <summary>Estimates which feet stand on the ground in every frame.</summary>
    /// <returns>The contacts of all frames, in the order in which they were added.</returns>
    public FootContacts[] EstimateContacts()
    {
        float[] ground = EstimateGround();
        var contacts = new FootContacts[_samples.Count];
        FootContacts last = default;
        for (int i = 0; i < contacts.Length; i++)
        {
            if (_samples[i].IsFinite)
            {
                int before = FindFinite(i, -1);
                int after = FindFinite(i, 1);
                last = _samples[i].Touches(last, _samples[before], _samples[after], _times[after] - _times[before], ground[i]);
            }

            contacts[i] = last;
        }

        return contacts;
    }

    // The next usable frame in a direction; the frame itself if there is none.
    private int FindFinite(int frame, int step)
    {
        for (int i = frame + step; i >= 0 && i < _samples.Count; i += step)
        {
            if (_samples[i].IsFinite)
                return i;
        }

        return frame;
    }

    // Applies GroundEstimator from both ends, so a step up is known in advance.
    private float[] EstimateGround()
    {
        float[] heights = [.. _samples.Select(static sample => sample.Lowest)];
        var forward = new GroundEstimator();
        var backward = new GroundEstimator();
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
