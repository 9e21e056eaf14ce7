namespace NeuronMocap.Motion;

/// <summary>
/// Computes velocities by finite differences, for any spacing of the frames. Does not allocate memory. Thread-safe.
/// </summary>
/// <remarks>
/// A pose is a span with any number of transforms, usually in the world. Times are in seconds on any clock.
/// </remarks>
public static class PoseVelocity
{
    /// <summary>
    /// Computes the velocity from one frame to the next, for live use. The result is exact halfway between the two frames, and therefore half a
    /// frame old. Frames at the same time give zero.
    /// </summary>
    /// <param name="earlier">The previous frame.</param>
    /// <param name="later">The latest frame.</param>
    /// <param name="elapsed">Seconds between the two frames.</param>
    /// <param name="velocities">Receives as many velocities as <paramref name="later"/> has transforms.</param>
    /// <exception cref="ArgumentException">The earlier pose has fewer transforms than the later one, or the destination is too short.</exception>
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
    /// Computes the velocity at a frame from its two neighbours, for takes. The result is exact for constant acceleration, even if the neighbours
    /// are not equally far away.
    /// </summary>
    /// <param name="before">The previous frame.</param>
    /// <param name="now">The frame.</param>
    /// <param name="after">The next frame.</param>
    /// <param name="elapsedBefore">Seconds from the previous frame to the frame.</param>
    /// <param name="elapsedAfter">Seconds from the frame to the next frame.</param>
    /// <param name="velocities">Receives as many velocities as <paramref name="now"/> has transforms.</param>
    /// <exception cref="ArgumentException">A neighbour has fewer transforms than the frame, or the destination is too short.</exception>
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

        // The nearer neighbour is more accurate. Each difference is weighted by the length of the other.
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
