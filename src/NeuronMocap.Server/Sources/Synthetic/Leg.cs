using System.Numerics;

namespace NeuronMocap.Server.Sources.Synthetic;

// Exact inverse kinematics of a thigh and a shin with a hinge between them. The knee bends forward only.
internal static class Leg
{
    // Thigh, shin and foot have consecutive numbers. Their transforms are relative to the parent; that of the hips is relative to the world.
    public static void Solve(Bone thigh, in FootPose foot, Quaternion forward, Span<BoneTransform> pose)
    {
        BoneTransform hips = pose[(int)Bone.Hips];
        Vector3 toAnkle = foot.Ankle - hips.TransformPoint(pose[(int)thigh].Position);
        float upper = pose[(int)thigh + 1].Position.Length();
        float lower = pose[(int)thigh + 2].Position.Length();
        float distance = Math.Min(toAnkle.Length(), upper + lower);

        // The leg as a straight line: Y from the ankle to the hip, X along the hinge, to the left.
        Vector3 up = Vector3.Normalize(-toAnkle);
        Vector3 left = Vector3.Normalize(Vector3.Cross(up, Vector3.Transform(Vector3.UnitZ, forward)));
        Vector3 ahead = Vector3.Cross(left, up);
        Quaternion stick = Quaternion.CreateFromRotationMatrix(new Matrix4x4(
            left.X, left.Y, left.Z, 0, up.X, up.Y, up.Z, 0, ahead.X, ahead.Y, ahead.Z, 0, 0, 0, 0, 1));

        Quaternion thighWorld = stick * Turn.X(-AngleOpposite(lower, upper, distance));
        Quaternion shinWorld = stick * Turn.X(AngleOpposite(upper, lower, distance));
        Rotate(pose, thigh, Quaternion.Conjugate(hips.Rotation) * thighWorld);
        Rotate(pose, thigh + 1, Quaternion.Conjugate(thighWorld) * shinWorld);
        Rotate(pose, thigh + 2, Quaternion.Conjugate(shinWorld) * foot.Rotation);
    }

    // Law of cosines, in degrees. Double precision is needed: near a straight leg, float would make the knee tremble.
    private static float AngleOpposite(double side, double other, double another)
    {
        double cosine = ((other * other) + (another * another) - (side * side)) / (2 * other * another);
        return (float)(Math.Acos(Math.Min(1, cosine)) * (180 / Math.PI));
    }

    private static void Rotate(Span<BoneTransform> pose, Bone bone, Quaternion rotation) =>
        pose[(int)bone] = pose[(int)bone] with { Rotation = Quaternion.Normalize(rotation) };
}
