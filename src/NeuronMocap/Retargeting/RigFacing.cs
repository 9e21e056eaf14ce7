using System.Numerics;

namespace NeuronMocap.Retargeting;

// The orientation of a resting character in its root, to quarter turns, from the directions of its left side and its head.
internal static class RigFacing
{
    // The cosine of 30 degrees. A rest pose further away from every axis has no clear direction.
    private const float Clear = 0.866f;

    private static ReadOnlySpan<HumanoidBone> LeftSide =>
        [HumanoidBone.LeftUpperLeg, HumanoidBone.LeftFoot, HumanoidBone.LeftShoulder, HumanoidBone.LeftUpperArm, HumanoidBone.LeftHand];

    public static Quaternion Find(TargetRig rig)
    {
        var right = Vector3.Zero;
        foreach (HumanoidBone left in LeftSide)
            right += Way(rig, left, left + 1);

        Vector3 up = Way(rig, HumanoidBone.Hips, HumanoidBone.Head)
            + Way(rig, HumanoidBone.LeftFoot, HumanoidBone.LeftUpperLeg)
            + Way(rig, HumanoidBone.RightFoot, HumanoidBone.RightUpperLeg);
        if (!TrySnap(up, out Vector3 y) || !TrySnap(right, out Vector3 x) || Vector3.Dot(x, y) != 0)
            return Quaternion.Identity;

        Vector3 z = Vector3.Cross(x, y);
        return Quaternion.CreateFromRotationMatrix(
            new Matrix4x4(x.X, x.Y, x.Z, 0, y.X, y.Y, y.Z, 0, z.X, z.Y, z.Z, 0, 0, 0, 0, 1));
    }

    private static Vector3 Way(TargetRig rig, HumanoidBone from, HumanoidBone to)
    {
        (int start, int end) = (rig.GetNode(from), rig.GetNode(to));
        return start < 0 || end < 0 ? Vector3.Zero : rig.RestPositions[end] - rig.RestPositions[start];
    }

    private static bool TrySnap(Vector3 direction, out Vector3 axis)
    {
        float clear = Clear * direction.Length();
        axis = new Vector3(Snap(direction.X, clear), Snap(direction.Y, clear), Snap(direction.Z, clear));
        return axis != Vector3.Zero;
    }

    private static float Snap(float component, float clear) => Math.Abs(component) > clear ? Math.Sign(component) : 0;
}
