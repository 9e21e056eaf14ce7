using System.Numerics;

namespace NeuronMocap.Retargeting;

/// <summary>
/// Inverse kinematics of two bones: a leg that places a foot, or an arm that places a hand. The solution has closed form and keeps the bone lengths.
/// The caller chooses units and handedness. Allocates nothing; thread-safe.
/// </summary>
public static class TwoBoneIk
{
    /// <summary>
    /// The least distance of the middle joint on the forward side of a straight limb, as a fraction of the limb's length. A smaller bend is noise and
    /// has no reliable direction.
    /// </summary>
    public const float MinForward = 0.01f;

    // Shorter vectors have no direction. With metres as the unit, this is a micrometre.
    private const float Nothing = 1e-6f;

    /// <summary>
    /// Turns a limb so that its end reaches the target.
    /// </summary>
    /// <remarks>
    /// A clearly bent limb keeps the direction of its bend, carried along by the shortest turn. A limb that is straight, or bent the wrong way, bends
    /// forward. If the target is too far, the limb is stretched towards it. If the target is too close, the limb is folded.
    /// </remarks>
    /// <param name="root">Start of the limb, such as the hip joint.</param>
    /// <param name="middle">The joint between the two bones, such as the knee.</param>
    /// <param name="end">End of the limb, such as the ankle.</param>
    /// <param name="target">The wanted position of the end.</param>
    /// <param name="forward">The bend direction of the joint as the limb is now: for a knee, where it points. Any length except zero.</param>
    /// <returns>The turns. They are identities if a value is not finite or a bone has length zero.</returns>
    public static TwoBoneSolution Solve(Vector3 root, Vector3 middle, Vector3 end, Vector3 target, Vector3 forward)
    {
        float upper = Vector3.Distance(root, middle);
        float lower = Vector3.Distance(middle, end);
        float reach = upper + lower;
        if (!(upper > Nothing && lower > Nothing) || !IsFinite(reach + Vector3.Distance(root, target) + forward.LengthSquared()))
            return new TwoBoneSolution(Quaternion.Identity, Quaternion.Identity, middle, end);

        Vector3 axis = Direction(end - root, middle - root);
        Vector3 newAxis = Direction(target - root, axis);
        float distance = Math.Clamp(Vector3.Distance(root, target), Math.Abs(upper - lower), reach);

        // The whole limb first turns towards the target. The remaining turn is the bend, in the limb's original plane.
        Quaternion swing = ShortestTurn(axis, newAxis);
        Vector3 bend = Vector3.Transform(BendDirection(middle - root, axis, forward, MinForward * reach), swing);
        float along = distance > Nothing ? ((upper * upper) - (lower * lower) + (distance * distance)) / (2 * distance) : 0;
        along = Math.Clamp(along, -upper, upper);
        float aside = MathF.Sqrt((upper - along) * (upper + along));
        Vector3 newMiddle = root + (newAxis * along) + (bend * aside);
        Vector3 newEnd = root + (newAxis * distance);

        return new TwoBoneSolution(
            Turn(swing, middle - root, newMiddle - root),
            Turn(swing, end - middle, newEnd - newMiddle),
            newMiddle,
            newEnd);
    }

    /// <summary>Gets the shortest turn from one direction to another.</summary>
    /// <param name="from">A unit vector.</param>
    /// <param name="to">A unit vector.</param>
    /// <returns>A unit quaternion. For opposite directions, half a turn about some axis between them.</returns>
    internal static Quaternion ShortestTurn(Vector3 from, Vector3 to)
    {
        // From the half-way vector, which is as exact for small angles as for large ones.
        Vector3 half = from + to;
        float length = half.Length();
        if (length < 1e-3f)
            return new Quaternion(Perpendicular(from), 0);

        half /= length;
        return Quaternion.Normalize(new Quaternion(Vector3.Cross(from, half), Vector3.Dot(from, half)));
    }

    /// <summary>Gets a unit vector perpendicular to another.</summary>
    internal static Vector3 Perpendicular(Vector3 unit) =>
        Vector3.Normalize(Vector3.Cross(unit, Math.Abs(unit.X) < 0.7f ? Vector3.UnitX : Vector3.UnitY));

    // Keeps the forward part of the bend at or above the minimum. The sideways part stays. The direction thus changes gradually as the limb
    // straightens.
    private static Vector3 BendDirection(Vector3 middle, Vector3 axis, Vector3 forward, float least)
    {
        // Goes by the axis that the joint turns about, which is valid however far the limb is folded.
        Vector3 ahead = Vector3.Cross(Vector3.Cross(Vector3.Normalize(middle), forward), axis);
        ahead = ahead.LengthSquared() > Nothing * forward.LengthSquared() ? Vector3.Normalize(ahead) : Perpendicular(axis);
        Vector3 bend = middle - (axis * Vector3.Dot(middle, axis));
        return Vector3.Normalize(bend + (ahead * Math.Max(0, least - Vector3.Dot(bend, ahead))));
    }

    private static Quaternion Turn(Quaternion swing, Vector3 from, Vector3 to) => Quaternion.Normalize(
        ShortestTurn(Vector3.Normalize(Vector3.Transform(from, swing)), Vector3.Normalize(to)) * swing);

    private static Vector3 Direction(Vector3 vector, Vector3 otherwise) =>
        Vector3.Normalize(vector.LengthSquared() > Nothing * Nothing ? vector : otherwise);

    private static bool IsFinite(float value) => !float.IsNaN(value) && !float.IsInfinity(value);
}
