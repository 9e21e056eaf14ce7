using NeuronMocap.Skeleton;

namespace NeuronMocap;

/// <summary>
/// The 59 bones in the order of the BVH stream (manual, Appendix A). Use <see cref="CalculationOrder"/> for the order of the calculation stream.
/// <see cref="BoneHierarchy"/> gives names and parents, which depend on the <see cref="SkeletonVariant"/>.
/// </summary>
public enum Bone
{
    /// <summary>
    /// Root of the body. Its position and rotation are relative to the Reference node, or to the world if there is no Reference node.
    /// </summary>
    Hips = 0,

    /// <summary>Right thigh.</summary>
    RightUpLeg,

    /// <summary>Right shin.</summary>
    RightLeg,

    /// <summary>Right foot.</summary>
    RightFoot,

    /// <summary>Left thigh.</summary>
    LeftUpLeg,

    /// <summary>Left shin.</summary>
    LeftLeg,

    /// <summary>Left foot.</summary>
    LeftFoot,

    /// <summary>Lowest spine bone.</summary>
    Spine,

    /// <summary>Second spine bone.</summary>
    Spine1,

    /// <summary>Third spine bone. In the Neck1 variant it is the parent of the shoulders.</summary>
    Spine2,

    /// <summary>Lower neck. In the Spine3 variant it is called Spine3, belongs to the spine, and is the parent of the shoulders.</summary>
    Neck,

    /// <summary>Upper neck. In the Spine3 variant it is called Neck and is the whole neck.</summary>
    Neck1,

    /// <summary>Head.</summary>
    Head,

    /// <summary>Right collar bone.</summary>
    RightShoulder,

    /// <summary>Right upper arm.</summary>
    RightArm,

    /// <summary>Right forearm.</summary>
    RightForeArm,

    /// <summary>Right hand.</summary>
    RightHand,

    /// <summary>Right thumb, first bone.</summary>
    RightHandThumb1,

    /// <summary>Right thumb, second bone.</summary>
    RightHandThumb2,

    /// <summary>Right thumb, third bone.</summary>
    RightHandThumb3,

    /// <summary>Right palm bone of the index finger.</summary>
    RightInHandIndex,

    /// <summary>Right index finger, first bone.</summary>
    RightHandIndex1,

    /// <summary>Right index finger, second bone.</summary>
    RightHandIndex2,

    /// <summary>Right index finger, third bone.</summary>
    RightHandIndex3,

    /// <summary>Right palm bone of the middle finger.</summary>
    RightInHandMiddle,

    /// <summary>Right middle finger, first bone.</summary>
    RightHandMiddle1,

    /// <summary>Right middle finger, second bone.</summary>
    RightHandMiddle2,

    /// <summary>Right middle finger, third bone.</summary>
    RightHandMiddle3,

    /// <summary>Right palm bone of the ring finger.</summary>
    RightInHandRing,

    /// <summary>Right ring finger, first bone.</summary>
    RightHandRing1,

    /// <summary>Right ring finger, second bone.</summary>
    RightHandRing2,

    /// <summary>Right ring finger, third bone.</summary>
    RightHandRing3,

    /// <summary>Right palm bone of the little finger.</summary>
    RightInHandPinky,

    /// <summary>Right little finger, first bone.</summary>
    RightHandPinky1,

    /// <summary>Right little finger, second bone.</summary>
    RightHandPinky2,

    /// <summary>Right little finger, third bone.</summary>
    RightHandPinky3,

    /// <summary>Left collar bone.</summary>
    LeftShoulder,

    /// <summary>Left upper arm.</summary>
    LeftArm,

    /// <summary>Left forearm.</summary>
    LeftForeArm,

    /// <summary>Left hand.</summary>
    LeftHand,

    /// <summary>Left thumb, first bone.</summary>
    LeftHandThumb1,

    /// <summary>Left thumb, second bone.</summary>
    LeftHandThumb2,

    /// <summary>Left thumb, third bone.</summary>
    LeftHandThumb3,

    /// <summary>Left palm bone of the index finger.</summary>
    LeftInHandIndex,

    /// <summary>Left index finger, first bone.</summary>
    LeftHandIndex1,

    /// <summary>Left index finger, second bone.</summary>
    LeftHandIndex2,

    /// <summary>Left index finger, third bone.</summary>
    LeftHandIndex3,

    /// <summary>Left palm bone of the middle finger.</summary>
    LeftInHandMiddle,

    /// <summary>Left middle finger, first bone.</summary>
    LeftHandMiddle1,

    /// <summary>Left middle finger, second bone.</summary>
    LeftHandMiddle2,

    /// <summary>Left middle finger, third bone.</summary>
    LeftHandMiddle3,

    /// <summary>Left palm bone of the ring finger.</summary>
    LeftInHandRing,

    /// <summary>Left ring finger, first bone.</summary>
    LeftHandRing1,

    /// <summary>Left ring finger, second bone.</summary>
    LeftHandRing2,

    /// <summary>Left ring finger, third bone.</summary>
    LeftHandRing3,

    /// <summary>Left palm bone of the little finger.</summary>
    LeftInHandPinky,

    /// <summary>Left little finger, first bone.</summary>
    LeftHandPinky1,

    /// <summary>Left little finger, second bone.</summary>
    LeftHandPinky2,

    /// <summary>Left little finger, third bone.</summary>
    LeftHandPinky3,
}
