using System.Numerics;

namespace NeuronMocap.Tool.Watch.Live;

/// <summary>
/// How much of the world a view shows. It grows in steps to hold all poses it has seen, and never shrinks by itself, because a scale that
/// follows every frame makes the skeleton breathe.
/// </summary>
internal sealed class ViewScale
{
    // A broken value in one frame must not make the person a dot for good.
    private const float Limit = 1000;
    private const float Step = 10;

    /// <summary>Centimetres shown to each side of the hips.</summary>
    public float Reach { get; private set; } = 50;

    /// <summary>Highest centimetre shown.</summary>
    public float Top { get; private set; } = 170;

    /// <summary>Lowest centimetre shown; 0 is the ground.</summary>
    public float Bottom { get; private set; } = -Step;

    /// <summary>Grows until it holds the pose.</summary>
    public void Include(ReadOnlySpan<Vector3> points)
    {
        Vector3 hips = points[(int)Bone.Hips];
        foreach (Vector3 point in points)
        {
            Reach = Grow(Reach, Math.Max(Math.Abs(point.X - hips.X), Math.Abs(point.Z - hips.Z)));
            Top = Grow(Top, point.Y);
            Bottom = -Grow(-Bottom, -point.Y);
        }
    }

    /// <summary>Dots for a centimetre, the same in both directions, so that everything fits.</summary>
    public float DotsPerCentimetre(BrailleCanvas canvas) =>
        Math.Min((canvas.Width - 1) / (2 * Reach), (canvas.Height - 1) / (Top - Bottom));

    private static float Grow(float current, float needed) =>
        needed > current && needed <= Limit ? MathF.Ceiling(needed / Step) * Step : current;
}
