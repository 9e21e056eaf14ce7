namespace NeuronMocap.Skeleton;

/// <summary>
/// The order of the bones in the calculation stream (manual, Appendix C): body without fingers first, head before neck and spine.
/// It differs from <see cref="Bone"/>, the order of the BVH stream.
/// </summary>
public static class CalculationOrder
{
    /// <summary>Number of bones of the body, which are in every calculation packet.</summary>
    public const int BodyBoneCount = 21;

    private static readonly Bone[] Order =
    [
        Bone.Hips,
        Bone.RightUpLeg, Bone.RightLeg, Bone.RightFoot,
        Bone.LeftUpLeg, Bone.LeftLeg, Bone.LeftFoot,
        Bone.RightShoulder, Bone.RightArm, Bone.RightForeArm, Bone.RightHand,
        Bone.LeftShoulder, Bone.LeftArm, Bone.LeftForeArm, Bone.LeftHand,
        Bone.Head, Bone.Neck1, Bone.Neck, Bone.Spine2, Bone.Spine1, Bone.Spine,
        Bone.RightHandThumb1, Bone.RightHandThumb2, Bone.RightHandThumb3,
        Bone.RightInHandIndex, Bone.RightHandIndex1, Bone.RightHandIndex2, Bone.RightHandIndex3,
        Bone.RightInHandMiddle, Bone.RightHandMiddle1, Bone.RightHandMiddle2, Bone.RightHandMiddle3,
        Bone.RightInHandRing, Bone.RightHandRing1, Bone.RightHandRing2, Bone.RightHandRing3,
        Bone.RightInHandPinky, Bone.RightHandPinky1, Bone.RightHandPinky2, Bone.RightHandPinky3,
        Bone.LeftHandThumb1, Bone.LeftHandThumb2, Bone.LeftHandThumb3,
        Bone.LeftInHandIndex, Bone.LeftHandIndex1, Bone.LeftHandIndex2, Bone.LeftHandIndex3,
        Bone.LeftInHandMiddle, Bone.LeftHandMiddle1, Bone.LeftHandMiddle2, Bone.LeftHandMiddle3,
        Bone.LeftInHandRing, Bone.LeftHandRing1, Bone.LeftHandRing2, Bone.LeftHandRing3,
        Bone.LeftInHandPinky, Bone.LeftHandPinky1, Bone.LeftHandPinky2, Bone.LeftHandPinky3,
    ];

    private static readonly byte[] Indices = Invert(Order);

    /// <summary>Gets the bones in the order of the calculation stream.</summary>
    public static ReadOnlySpan<Bone> Bones => Order;

    /// <summary>Gets the index of a bone in the calculation stream.</summary>
    /// <param name="bone">The bone.</param>
    /// <returns>0 to 58. Bones of the body have an index below 21.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The bone is not defined.</exception>
    public static int IndexOf(Bone bone) => Indices[BoneHierarchy.CheckedIndex(bone)];

    private static byte[] Invert(Bone[] order)
    {
        byte[] indices = new byte[order.Length];
        for (int i = 0; i < order.Length; i++)
            indices[(int)order[i]] = (byte)i;

        return indices;
    }
}
