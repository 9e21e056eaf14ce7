using System.Numerics;

namespace NeuronMocap.Retargeting;

/// <summary>
/// Inverse kinematics of two bones: a leg whose foot has a place to be, an arm whose hand has. Solved in closed form; the lengths are kept.
/// Units and handedness are the caller's. Allocates nothing; thread-safe.
/// </summary>
public static class TwoBoneIk
{
    /// <summary>
    /// How far the middle joint is kept on the forward side of a straight limb, as a part of the limb's length: below it a bend is noise,
    /// and its direction says nothing.
    /// </summary>
    public const float MinForward = 0.01f;

    // Shorter ones have no direction: a micrometre, if the unit is the metre.
    private const float Nothing = 1e-6f;

    /// <summary>
    /// Turns a limb so that its end comes to the target. A limb that is clearly bent keeps the direction of its bend, carried along by the shortest
    /// turn; one that is straight, or bent the wrong way, bends forward. A target out of reach gets the stretched limb, one too near the
    /// folded one.
    /// </summary>
    /// <param name="root">Where the limb begins: the hip.</param>
    /// <param name="middle">The joint between the two bones: the knee.</param>
    /// <param name="end">Where the limb ends: the ankle.</param>
    /// <param name="target">Where the end is to come to.</param>
    /// <param name="forward">Where the joint bends to as the limb is now: of a knee, the way that it points. Any length but zero.</param>
    /// <returns>The turns. Those that do nothing when a value is not a finite number, or when a bone has no length.</returns>
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

        // The whole limb first turns towards the target; what remains is the bend, in the plane that it had.
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

    /// <summary>The shortest turn that brings one direction to another.</summary>
    /// <param name="from">A unit vector.</param>
    /// <param name="to">A unit vector.</param>
    /// <returns>A unit quaternion; of opposite directions, half a turn about some axis between them.</returns>
    internal static Quaternion ShortestTurn(Vector3 from, Vector3 to)
    {
        // From the half-way vector: as exact for small angles as for large ones.
        Vector3 half = from + to;
        float length = half.Length();
        if (length < 1e-3f)
            return new Quaternion(Perpendicular(from), 0);

        half /= length;
        return Quaternion.Normalize(new Quaternion(Vector3.Cross(from, half), Vector3.Dot(from, half)));
    }

    /// <summary>Some unit vector at right angles to another.</summary>
    internal static Vector3 Perpendicular(Vector3 unit) =>
        Vector3.Normalize(Vector3.Cross(unit, Math.Abs(unit.X) < 0.7f ? Vector3.UnitX : Vector3.UnitY));

    // The part of the bend that points forward is at least so much; what points aside stays. So the direction changes gradually as the limb
    // straightens.
    private static Vector3 BendDirection(Vector3 middle, Vector3 axis, Vector3 forward, float least)
    {
        // By way of the axis that the joint turns about: that of a limb folded however far.
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
