using System.Numerics;

namespace NeuronMocap.Tool.Figures;

/// <summary>A pose of the take that is drawn as a skeleton.</summary>
/// <param name="Seconds">Time since the start of the take.</param>
/// <param name="Points">Positions of the points in the world.</param>
internal sealed record SampledPose(double Seconds, Vector3[] Points)
{
    /// <summary>Samples poses at regular times, including the first and last frame.</summary>
    public static SampledPose[] Take(PointMotion motion, int count)
    {
        long poses = Math.Min(count, motion.FrameCount);
        return [.. Enumerable.Range(0, (int)poses).Select(i => At(motion, poses == 1 ? 0 : (long)Math.Round(i * (motion.FrameCount - 1.0) / (poses - 1))))];
    }

    /// <summary>Gets the horizontal facing direction. Null if the points do not give it.</summary>
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
