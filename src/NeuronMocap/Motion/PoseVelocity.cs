namespace NeuronMocap.Motion;

/// <summary>
/// Velocities by finite differences, right for any spacing of the frames. Poses are spans of transforms, as many as there are, usually in the
/// world; times are seconds on any clock. Allocates nothing; thread-safe.
/// </summary>
public static class PoseVelocity
{
    /// <summary>
    /// The velocity from one frame to the next: what is known live. It is the true one halfway between the two, so half a frame old.
    /// Frames at the same time give zero.
    /// </summary>
    /// <param name="earlier">The frame before.</param>
    /// <param name="later">The newest frame.</param>
    /// <param name="elapsed">Seconds from one to the other.</param>
    /// <param name="velocities">Receives as many velocities as <paramref name="later"/> has transforms.</param>
    /// <exception cref="ArgumentException">The earlier pose has fewer transforms than the later, or there is less room.</exception>
    public static void ComputeBackward(
        ReadOnlySpan<BoneTransform> earlier, ReadOnlySpan<BoneTransform> later, double elapsed, Span<BoneVelocity> velocities)
    {
        Check(earlier, later, velocities);
        float rate = PerSecond(elapsed);
        for (int i = 0; i < later.Length; i++)
        {
            velocities[i] = new BoneVelocity(
                (later[i].Position - earlier[i].Position) * rate,
                QuaternionMath.TurnBetween(earlier[i].Rotation, later[i].Rotation) * rate);
        }
    }

    /// <summary>
    /// The velocity at a frame from its two neighbours: for takes. Exact for constant acceleration, also where the neighbours are not equally far.
    /// </summary>
    /// <param name="before">The frame before.</param>
    /// <param name="now">The frame.</param>
    /// <param name="after">The frame after.</param>
    /// <param name="elapsedBefore">Seconds from the frame before to the frame.</param>
    /// <param name="elapsedAfter">Seconds from the frame to the frame after.</param>
    /// <param name="velocities">Receives as many velocities as <paramref name="now"/> has transforms.</param>
    /// <exception cref="ArgumentException">A neighbour has fewer transforms than the frame, or there is less room.</exception>
    public static void ComputeCentral(
        ReadOnlySpan<BoneTransform> before,
        ReadOnlySpan<BoneTransform> now,
        ReadOnlySpan<BoneTransform> after,
        double elapsedBefore,
        double elapsedAfter,
        Span<BoneVelocity> velocities)
    {
        Check(before, now, velocities);
        Check(after, now, velocities);

        // The nearer neighbour tells more about this moment: each difference is weighted by the length of the other.
        double both = Math.Max(elapsedBefore, 0) + Math.Max(elapsedAfter, 0);
        float weightBefore = both > 0 ? (float)(Math.Max(elapsedAfter, 0) / both) : 0;
        float first = elapsedAfter > 0 ? PerSecond(elapsedBefore) * weightBefore : PerSecond(elapsedBefore);
        float second = elapsedBefore > 0 ? PerSecond(elapsedAfter) * (1 - weightBefore) : PerSecond(elapsedAfter);
        for (int i = 0; i < now.Length; i++)
        {
            velocities[i] = new BoneVelocity(
                ((now[i].Position - before[i].Position) * first) + ((after[i].Position - now[i].Position) * second),
                (QuaternionMath.TurnBetween(before[i].Rotation, now[i].Rotation) * first)
                    + (QuaternionMath.TurnBetween(now[i].Rotation, after[i].Rotation) * second));
        }
    }

    private static float PerSecond(double elapsed) => elapsed > 0 ? (float)(1 / elapsed) : 0;

    private static void Check(ReadOnlySpan<BoneTransform> neighbour, ReadOnlySpan<BoneTransform> pose, Span<BoneVelocity> velocities)
    {
        if (neighbour.Length < pose.Length)
            throw new ArgumentException("The neighbouring pose has fewer transforms.", nameof(neighbour));
        if (velocities.Length < pose.Length)
            throw new ArgumentException("There must be room for a velocity of each transform.", nameof(velocities));
    }
}
