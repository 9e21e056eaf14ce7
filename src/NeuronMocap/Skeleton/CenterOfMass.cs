using System.Numerics;

namespace NeuronMocap.Skeleton;

/// <summary>
/// Computes the centre of mass of the body. Allocates nothing; thread-safe.
/// </summary>
/// <remarks>
/// Masses and centres of the segments are those of men. They come from P. de Leva, "Adjustments to Zatsiorsky-Seluyanov's segment inertia
/// parameters", Journal of Biomechanics 29(9), 1996, Table 4. Masses are fractions of the body mass, so the actor's weight, which no stream
/// carries, is not needed. Neck and head are one segment. A hand includes its fingers.
/// <list type="bullet">
/// <item><description>The trunk has three segments. They follow the joints of the spine from the midpoint of the thighs to the lowest joint named
/// Neck.</description></item>
/// <item><description>The hand's centre lies on the line to the first joint of the middle finger.</description></item>
/// <item><description>The skeleton lacks a heel. It is assumed as low as the toes, and behind the ankle by a third of the distance from ankle to
/// toes.</description></item>
/// </list>
/// </remarks>
public static class CenterOfMass
{
    // Ends of the parts of the trunk, from the hips up, as fractions of the trunk.
    private const float PelvisEnd = 145.7f / 603.3f;
    private const float AbdomenEnd = (145.7f + 215.5f) / 603.3f;

    // Distance of each centre from the upper end of its part, as a fraction.
    private const float PelvisCenter = 0.6115f;
    private const float AbdomenCenter = 0.4502f;
    private const float ThoraxCenter = 0.5066f;

    private const float Head = 0.0694f;
    private const float Thorax = 0.1596f;
    private const float Abdomen = 0.1633f;
    private const float Pelvis = 0.1117f;
    private const float UpperArm = 0.0271f;
    private const float Forearm = 0.0162f;
    private const float Hand = 0.0061f;
    private const float Thigh = 0.1416f;
    private const float Shank = 0.0433f;
    private const float Foot = 0.0137f;

    internal const float WholeMass = Head + Thorax + Abdomen + Pelvis + (2 * (UpperArm + Forearm + Hand + Thigh + Shank + Foot));

    /// <summary>Computes the centre of mass of a pose.</summary>
    /// <param name="world">59 transforms in the world, in <see cref="Bone"/> order.</param>
    /// <param name="body">Determines the ends of head and feet, and the start of the neck.</param>
    /// <returns>A point in the axes and units of <paramref name="world"/>.</returns>
    /// <exception cref="ArgumentException">There are fewer than 59 transforms.</exception>
    public static Vector3 Compute(ReadOnlySpan<BoneTransform> world, SkeletonBody body)
    {
        ArgumentNullException.ThrowIfNull(body);
        ForwardKinematics.CheckPose(world, nameof(world));
        Bone neck = body.Variant == SkeletonVariant.Spine3 ? Bone.Neck1 : Bone.Neck;
        Vector3 headTop = JointPositions.GetEnd(world, body, Bone.Head);
        return (Vector3.Lerp(headTop, At(world, neck), 0.5002f) * Head)
            + GetTrunk(world, neck)
            + GetArm(world, Bone.RightArm, Bone.RightHandMiddle1)
            + GetArm(world, Bone.LeftArm, Bone.LeftHandMiddle1)
            + GetLeg(world, body, Bone.RightUpLeg)
            + GetLeg(world, body, Bone.LeftUpLeg);
    }

    private static Vector3 GetArm(ReadOnlySpan<BoneTransform> world, Bone arm, Bone knuckle) =>
        (Between(world, arm, arm + 1, 0.5772f) * UpperArm)
        + (Between(world, arm + 1, arm + 2, 0.4574f) * Forearm)
        + (Between(world, arm + 2, knuckle, 0.79f) * Hand);

    private static Vector3 GetLeg(ReadOnlySpan<BoneTransform> world, SkeletonBody body, Bone thigh)
    {
        Bone foot = thigh + 2;
        Vector3 toes = body.EndSites[(int)foot];
        var heel = new Vector3(toes.X / -3, toes.Y, toes.Z / -3);
        return (Between(world, thigh, thigh + 1, 0.4095f) * Thigh)
            + (Between(world, thigh + 1, foot, 0.4395f) * Shank)
            + (world[(int)foot].TransformPoint(Vector3.Lerp(heel, toes, 0.4415f)) * Foot);
    }

    private static Vector3 GetTrunk(ReadOnlySpan<BoneTransform> world, Bone neck)
    {
        Span<Vector3> points = stackalloc Vector3[neck - Bone.Spine + 2];
        points[0] = Between(world, Bone.RightUpLeg, Bone.LeftUpLeg, 0.5f);
        for (int i = 1; i < points.Length; i++)
            points[i] = At(world, Bone.Spine + i - 1);

        Vector3 pelvisEnd = Along(points, PelvisEnd);
        Vector3 abdomenEnd = Along(points, AbdomenEnd);
        return (Vector3.Lerp(pelvisEnd, points[0], PelvisCenter) * Pelvis)
            + (Vector3.Lerp(abdomenEnd, pelvisEnd, AbdomenCenter) * Abdomen)
            + (Vector3.Lerp(points[^1], abdomenEnd, ThoraxCenter) * Thorax);
    }

    private static Vector3 Along(ReadOnlySpan<Vector3> points, float part)
    {
        float length = 0;
        for (int i = 1; i < points.Length; i++)
            length += Vector3.Distance(points[i - 1], points[i]);

        float rest = length * part;
        for (int i = 1; i < points.Length; i++)
        {
            float step = Vector3.Distance(points[i - 1], points[i]);
            if (rest < step)
                return Vector3.Lerp(points[i - 1], points[i], rest / step);

            rest -= step;
        }

        return points[^1];
    }

    private static Vector3 At(ReadOnlySpan<BoneTransform> world, Bone bone) => world[(int)bone].Position;

    private static Vector3 Between(ReadOnlySpan<BoneTransform> world, Bone from, Bone to, float part) =>
        Vector3.Lerp(At(world, from), At(world, to), part);
}
