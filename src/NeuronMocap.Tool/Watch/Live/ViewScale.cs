using System.Numerics;

namespace NeuronMocap.Tool.Watch.Live;

/// <summary>The part of the world that a view shows.</summary>
/// <remarks>
/// The scale grows in steps to hold all poses so far, and it does not shrink. A scale that follows every frame would make the skeleton pulsate.
/// </remarks>
internal sealed class ViewScale
{
    // A broken value in one frame must not reduce the person to a dot permanently.
    private const float Limit = 1000;
    private const float Step = 10;

    /// <summary>Centimetres shown on each side of the hips.</summary>
    public float Reach { get; private set; } = 50;

    /// <summary>Highest visible point in centimetres.</summary>
    public float Top { get; private set; } = 170;

    /// <summary>Lowest visible point in centimetres; 0 is the ground.</summary>
    public float Bottom { get; private set; } = -Step;

    /// <summary>Grows the scale until it holds the pose.</summary>
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

    /// <summary>Gets the number of dots for a centimetre, the same in both directions, so that everything fits.</summary>
    public float DotsPerCentimetre(BrailleCanvas canvas) =>
        Math.Min((canvas.Width - 1) / (2 * Reach), (canvas.Height - 1) / (Top - Bottom));

    private static float Grow(float current, float needed) =>
        needed > current && needed <= Limit ? MathF.Ceiling(needed / Step) * Step : current;
}
