using System.Numerics;

namespace NeuronMocap.Retargeting;

// The direction of a bone in a T-pose, in Unity's axes: left is -X. Next is the joint at its end. A hand has knuckles instead, from the index finger
// to the little finger.
internal sealed record TPoseSegment(HumanoidBone Bone, HumanoidBone? Next, Vector3 Direction, float Tolerance)
{
    // Tolerances in degrees. Within them, arms and legs look straight. Hands, fingers and feet vary from rig to rig.
    public const float Straight = 10;
    public const float Palm = 35;
    private const float Loose = 25;
    private const float Fingers = 35;

    public static TPoseSegment[] All { get; } = [.. Side(0, -Vector3.UnitX), .. Side(1, Vector3.UnitX)];

    public HumanoidBone[] Knuckles { get; init; } = [];

    public bool IsFoot => Bone is HumanoidBone.LeftFoot or HumanoidBone.RightFoot;

    private static IEnumerable<TPoseSegment> Side(int right, Vector3 outwards)
    {
        HumanoidBone Of(HumanoidBone left) => left + right;
        yield return new(Of(HumanoidBone.LeftUpperLeg), Of(HumanoidBone.LeftLowerLeg), -Vector3.UnitY, Straight);
        yield return new(Of(HumanoidBone.LeftLowerLeg), Of(HumanoidBone.LeftFoot), -Vector3.UnitY, Straight);
        yield return new(Of(HumanoidBone.LeftFoot), Of(HumanoidBone.LeftToes), Vector3.UnitZ, Loose);
        yield return new(Of(HumanoidBone.LeftUpperArm), Of(HumanoidBone.LeftLowerArm), outwards, Straight);
        yield return new(Of(HumanoidBone.LeftLowerArm), Of(HumanoidBone.LeftHand), outwards, Straight);

        // All fingers except the thumb: rigs differ in the rest pose of the thumb.
        HumanoidBone index = right == 0 ? HumanoidBone.LeftIndexProximal : HumanoidBone.RightIndexProximal;
        yield return new(Of(HumanoidBone.LeftHand), null, outwards, Loose) { Knuckles = [index, index + 3, index + 6, index + 9] };
        for (int finger = 0; finger < 4; finger++)
        {
            yield return new(index + (finger * 3), index + (finger * 3) + 1, outwards, Fingers);
            yield return new(index + (finger * 3) + 1, index + (finger * 3) + 2, outwards, Fingers);
        }
    }
}
