namespace NeuronMocap.Retargeting;

/// <summary>
/// The 55 bones of Unity's Humanoid rigs. Names and numbers match Unity's HumanBodyBones. Every rig has 15 of them; the others are optional.
/// </summary>
public enum HumanoidBone
{
    /// <summary>Root of the body.</summary>
    Hips = 0,

    /// <summary>Left thigh.</summary>
    LeftUpperLeg,

    /// <summary>Right thigh.</summary>
    RightUpperLeg,

    /// <summary>Left shin.</summary>
    LeftLowerLeg,

    /// <summary>Right shin.</summary>
    RightLowerLeg,

    /// <summary>Left foot.</summary>
    LeftFoot,

    /// <summary>Right foot.</summary>
    RightFoot,

    /// <summary>Lowest spine bone.</summary>
    Spine,

    /// <summary>Chest; optional.</summary>
    Chest,

    /// <summary>Neck; optional.</summary>
    Neck,

    /// <summary>Head.</summary>
    Head,

    /// <summary>Left collar bone; optional.</summary>
    LeftShoulder,

    /// <summary>Right collar bone; optional.</summary>
    RightShoulder,

    /// <summary>Left upper arm.</summary>
    LeftUpperArm,

    /// <summary>Right upper arm.</summary>
    RightUpperArm,

    /// <summary>Left forearm.</summary>
    LeftLowerArm,

    /// <summary>Right forearm.</summary>
    RightLowerArm,

    /// <summary>Left hand.</summary>
    LeftHand,

    /// <summary>Right hand.</summary>
    RightHand,

    /// <summary>Left toes; not in the stream.</summary>
    LeftToes,

    /// <summary>Right toes; not in the stream.</summary>
    RightToes,

    /// <summary>Left eye; not in the stream.</summary>
    LeftEye,

    /// <summary>Right eye; not in the stream.</summary>
    RightEye,

    /// <summary>Jaw; not in the stream.</summary>
    Jaw,

    /// <summary>Left thumb, first bone; optional.</summary>
    LeftThumbProximal,

    /// <summary>Left thumb, second bone; optional.</summary>
    LeftThumbIntermediate,

    /// <summary>Left thumb, third bone; optional.</summary>
    LeftThumbDistal,

    /// <summary>Left index finger, first bone; optional.</summary>
    LeftIndexProximal,

    /// <summary>Left index finger, second bone; optional.</summary>
    LeftIndexIntermediate,

    /// <summary>Left index finger, third bone; optional.</summary>
    LeftIndexDistal,

    /// <summary>Left middle finger, first bone; optional.</summary>
    LeftMiddleProximal,

    /// <summary>Left middle finger, second bone; optional.</summary>
    LeftMiddleIntermediate,

    /// <summary>Left middle finger, third bone; optional.</summary>
    LeftMiddleDistal,

    /// <summary>Left ring finger, first bone; optional.</summary>
    LeftRingProximal,

    /// <summary>Left ring finger, second bone; optional.</summary>
    LeftRingIntermediate,

    /// <summary>Left ring finger, third bone; optional.</summary>
    LeftRingDistal,

    /// <summary>Left little finger, first bone; optional.</summary>
    LeftLittleProximal,

    /// <summary>Left little finger, second bone; optional.</summary>
    LeftLittleIntermediate,

    /// <summary>Left little finger, third bone; optional.</summary>
    LeftLittleDistal,

    /// <summary>Right thumb, first bone; optional.</summary>
    RightThumbProximal,

    /// <summary>Right thumb, second bone; optional.</summary>
    RightThumbIntermediate,

    /// <summary>Right thumb, third bone; optional.</summary>
    RightThumbDistal,

    /// <summary>Right index finger, first bone; optional.</summary>
    RightIndexProximal,

    /// <summary>Right index finger, second bone; optional.</summary>
    RightIndexIntermediate,

    /// <summary>Right index finger, third bone; optional.</summary>
    RightIndexDistal,

    /// <summary>Right middle finger, first bone; optional.</summary>
    RightMiddleProximal,

    /// <summary>Right middle finger, second bone; optional.</summary>
    RightMiddleIntermediate,

    /// <summary>Right middle finger, third bone; optional.</summary>
    RightMiddleDistal,

    /// <summary>Right ring finger, first bone; optional.</summary>
    RightRingProximal,

    /// <summary>Right ring finger, second bone; optional.</summary>
    RightRingIntermediate,

    /// <summary>Right ring finger, third bone; optional.</summary>
    RightRingDistal,

    /// <summary>Right little finger, first bone; optional.</summary>
    RightLittleProximal,

    /// <summary>Right little finger, second bone; optional.</summary>
    RightLittleIntermediate,

    /// <summary>Right little finger, third bone; optional.</summary>
    RightLittleDistal,

    /// <summary>Upper chest, above the chest; optional.</summary>
    UpperChest,
}
