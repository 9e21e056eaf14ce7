using System.Numerics;

namespace NeuronMocap.Server.Sources.Synthetic;

// Rotations of a right arm; the left arm mirrors them. At rest the arm points along -X, the palm faces down and the thumb points forward. A turn
// about Z lowers the arm, about Y bends it forward, and about X twists it.
internal readonly struct Arm(Quaternion shoulder, Quaternion upper, Quaternion fore, Quaternion hand)
{
    private readonly Quaternion _shoulder = shoulder;
    private readonly Quaternion _upper = upper;
    private readonly Quaternion _fore = fore;
    private readonly Quaternion _hand = hand;

    // Backward is 1 at the rear end of the swing and -1 at the front end.
    public static Arm Swing(float backward, float walking, float breath) => new(
        Turn.Z(-breath),
        Turn.X((backward * 20) - (walking * 2)) * Turn.Z(77 - breath),
        Turn.Y(14 + (walking * 10) - (backward * 11)),
        Turn.Z(5) * Turn.Y(-3 - (backward * 5)));

    public static Arm Wave(float seconds)
    {
        float phase = seconds * (2 * MathF.PI * 1.5f);
        return new Arm(
            Turn.Z(-9),
            Turn.Y(22) * Turn.Z(4 - (3 * MathF.Sin(phase))) * Turn.X(-80),
            Turn.Y(82 + (20 * MathF.Sin(phase))),
            Turn.Y(12 * MathF.Sin(phase - 0.7f)) * Turn.Z(-8));
    }

    // Holds both hands in front of the chest, palms up.
    public static Arm ShowHand(float seconds) => new(
        Turn.Y(6),
        Turn.X(-22) * Turn.Z(70),
        Turn.Y(88 + (4 * MathF.Sin(seconds * 2.1f))) * Turn.X(-52),
        Turn.Z(-10));

    public static Arm Stretch(float seconds) => new(
        Turn.Z(-17),
        Turn.Y(-6) * Turn.Z(-62 - (5 * MathF.Sin(seconds * 1.6f))) * Turn.X(-25),
        Turn.Y(16),
        Turn.Z(-14));

    public Arm Blend(in Arm other, float amount) => new(
        Quaternion.Slerp(_shoulder, other._shoulder, amount),
        Quaternion.Slerp(_upper, other._upper, amount),
        Quaternion.Slerp(_fore, other._fore, amount),
        Quaternion.Slerp(_hand, other._hand, amount));

    public void Write(bool right, Span<BoneTransform> pose)
    {
        Bone bone = right ? Bone.RightShoulder : Bone.LeftShoulder;
        Write(pose, bone, right, _shoulder);
        Write(pose, bone + 1, right, _upper);
        Write(pose, bone + 2, right, _fore);
        Write(pose, bone + 3, right, _hand);
    }

    private static void Write(Span<BoneTransform> pose, Bone bone, bool right, Quaternion rotation) =>
        pose[(int)bone] = pose[(int)bone] with { Rotation = right ? rotation : Turn.Mirror(rotation) };
}
