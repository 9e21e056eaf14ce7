using System.Numerics;

namespace NeuronMocap.Server.Sources.Synthetic;

// Spine, neck and head. The spine turns against the pelvis, leans and breathes. The neck cancels the movement that would reach the head.
internal static class Torso
{
    public static void Write(in GaitMoment moment, in Gesture gesture, float breath, Span<BoneTransform> pose)
    {
        float stretch = gesture.AmountOf(GestureKind.Stretch);
        float look = gesture.AmountOf(GestureKind.LookAround) * MathF.Sin(gesture.Seconds * (2 * MathF.PI / 3.2f));

        // Each spine bone gets a third of every angle. A walking body leans forward, and into the ring, which is to the left.
        float pitch = (moment.Walking * 1.2f) - (stretch * 2.8f) + (gesture.AmountOf(GestureKind.CountFingers) * 2);
        float yaw = (-moment.Stride * 3.4f) + (look * 5) + (moment.Walking * 1.5f);
        float roll = (-moment.Weight * 1.3f) - (moment.Walking * 0.8f);
        Quaternion bend = Turn.Y(yaw) * Turn.Z(roll);
        Write(pose, Bone.Spine, bend * Turn.X(pitch));
        Write(pose, Bone.Spine1, bend * Turn.X(pitch - (0.4f * breath)));
        Write(pose, Bone.Spine2, bend * Turn.X(pitch - (0.8f * breath)));

        Quaternion chest = pose[(int)Bone.Hips].Rotation
            * pose[(int)Bone.Spine].Rotation
            * pose[(int)Bone.Spine1].Rotation
            * pose[(int)Bone.Spine2].Rotation;
        float headYaw = WalkingPath.Heading(moment.Station) + (moment.Walking * 10) + (look * 48);
        headYaw += moment.IsWalking ? gesture.AmountOf(GestureKind.Wave) * 30 : 0;
        float headPitch = 4 + (gesture.AmountOf(GestureKind.CountFingers) * 22) - (stretch * 16) + (look * look * 6) + (0.3f * breath);
        Quaternion nod = Quaternion.Conjugate(chest) * Turn.Y(headYaw) * Turn.X(headPitch) * Turn.Z(-look * 4);

        // Parts of one rotation about the same axis. Together they make up the whole rotation.
        Write(pose, Bone.Neck, Quaternion.Slerp(Quaternion.Identity, nod, 0.25f));
        Write(pose, Bone.Neck1, Quaternion.Slerp(Quaternion.Identity, nod, 0.35f));
        Write(pose, Bone.Head, Quaternion.Slerp(Quaternion.Identity, nod, 0.4f));
    }

    private static void Write(Span<BoneTransform> pose, Bone bone, Quaternion rotation) =>
        pose[(int)bone] = pose[(int)bone] with { Rotation = rotation };
}
