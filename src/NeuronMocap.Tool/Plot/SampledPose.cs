using System.Numerics;

namespace NeuronMocap.Tool.Plot;

/// <summary>A moment of the take that is drawn as a skeleton.</summary>
/// <param name="Seconds">Since the take's beginning.</param>
/// <param name="Points">Where the points are in the world.</param>
internal sealed record SampledPose(double Seconds, Vector3[] Points)
{
    /// <summary>Takes poses at regular times, the first and the last frame among them.</summary>
    public static SampledPose[] Take(PointMotion motion, int count)
    {
        long poses = Math.Min(count, motion.FrameCount);
        return [.. Enumerable.Range(0, (int)poses).Select(i => At(motion, poses == 1 ? 0 : (long)Math.Round(i * (motion.FrameCount - 1.0) / (poses - 1))))];
    }

    /// <summary>Where the body faces, horizontally; null when its points do not tell.</summary>
    public Vector3? Facing(PointRoles roles)
    {
        if (roles is not { LeftThigh: { } left, RightThigh: { } right })
            return null;

        Vector3 across = Points[left] - Points[right];
        Vector3 facing = Vector3.Cross(across with { Y = 0 }, Vector3.UnitY);
        return facing.LengthSquared() > 1e-6f && float.IsFinite(facing.LengthSquared()) ? Vector3.Normalize(facing) : null;
    }

    public static bool IsFinite(Vector3 point) => float.IsFinite(point.X) && float.IsFinite(point.Y) && float.IsFinite(point.Z);

    private static SampledPose At(PointMotion motion, long frame)
    {
        Vector3[] points = new Vector3[motion.PointCount];
        motion.GetPoints(frame, points);
        return new SampledPose(frame / motion.FrameRate, points);
    }
}
