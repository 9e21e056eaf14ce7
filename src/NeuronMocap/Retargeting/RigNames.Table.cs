using NeuronMocap.Skeleton;

namespace NeuronMocap.Retargeting;

// The names in the rigs of other programs. To add a rig, add a row, and a skeleton to tests/NeuronMocap.Tests/Retargeting/Rigs.
internal sealed partial record RigNames
{
    // The names in BVH files, and spellings that many rigs share: Mixamo, Ready Player Me, VRoid, VRM, Unreal Engine 4. Two-digit numbers start at
    // one, as in "spine_01". One-digit numbers count the bones after the first, as in "Spine1".
    private static readonly RigNames Own = new()
    {
        IsOwn = true,
        Hips = "hips/pelvis/hip",
        Spine = "spine/spine01 spine1/chest/spine02 spine2/upperchest/spine03",
        Neck = "neck/neck01 neck1/neck02",
        Leg = "upleg/upperleg/thigh leg/lowerleg/shin/calf foot/ankle",
        Arm = "shoulder/clavicle/collar/collarbone arm/upperarm/uparm forearm/lowerarm hand/wrist",
        Thumb = "handthumb1/thumb1/thumb01/thumbproximal handthumb2/thumb2/thumb02/thumbintermediate handthumb3/thumb3/thumb03/thumbdistal",
        Fingers = "index middle ring pinky/little",
        Joints = "inhand*/*metacarpal hand*1/*1/*01/*proximal hand*2/*2/*02/*intermediate hand*3/*3/*03/*distal",
    };

    private static readonly RigNames OwnSpine3 = Own with { Spine = Own.Spine + " spine3/spine04", Neck = "neck/neck01" };

    private static readonly RigNames[] OtherRigs =
    [
        new() // Daz 3D, Genesis to Genesis 8
        {
            Hips = "hip/pelvis",
            Spine = "abdomenlower/abdomen abdomenupper/abdomen2 chestlower/chest chestupper",
            Neck = "necklower/neck neckupper",
            Leg = "thighbend/thigh shin foot",
            Arm = "collar shldrbend/shldr forearmbend/forearm hand",
            Fingers = "index mid ring pinky",
            Joints = "carpal# *1 *2 *3",
        },
        new() // Daz 3D, Genesis 9
        {
            Hips = "hip/pelvis",
            Spine = "spine1 spine2 spine3 spine4",
            Neck = "neck1 neck2",
            Leg = "thigh shin foot",
            Arm = "shoulder upperarm forearm hand",
            Fingers = "index mid ring pinky",
            Joints = "*metacarpal *1 *2 *3",
        },
        new() // Character Creator
        {
            Hips = "hip/pelvis",
            Spine = "waist spine01 spine02",
            Neck = "necktwist01 necktwist02",
            Leg = "thigh calf foot",
            Arm = "clavicle upperarm forearm hand",
            Fingers = "index mid ring pinky",
            Joints = "- *1 *2 *3",
        },
        new() // Rigify
        {
            Hips = "spine",
            Spine = "spine001 spine002 spine003",
            Neck = "spine004 spine005",
            Head = "spine006",
            Leg = "thigh shin foot",
            Arm = "shoulder upperarm forearm hand",
            Thumb = "thumb01 thumb02 thumb03",
            Fingers = "findex fmiddle fring fpinky",
            Joints = "palm0# *01 *02 *03",
        },
        new() // 3ds Max Biped
        {
            Hips = "pelvis",
            Spine = "spine spine1 spine2 spine3 spine4",
            Neck = "neck neck1",
            Leg = "thigh calf foot",
            Arm = "clavicle upperarm forearm hand",
            Thumb = "finger0 finger01 finger02",
            Fingers = "finger1 finger2 finger3 finger4",
            Joints = "- * *1 *2",
        },
        new() // Unreal Engine 5
        {
            Hips = "pelvis",
            Spine = "spine01 spine02 spine03 spine04 spine05",
            Neck = "neck01 neck02",
            Leg = "thigh calf foot",
            Arm = "clavicle upperarm lowerarm hand",
            Thumb = "thumb01 thumb02 thumb03",
            Fingers = "index middle ring pinky",
            Joints = "*metacarpal *01 *02 *03",
        },
        new() // Xsens, segments
        {
            Hips = "pelvis",
            Spine = "l5 l3 t12 t8",
            Leg = "upperleg lowerleg foot",
            Arm = "shoulder upperarm forearm/lowerarm hand",
            Thumb = "firstmetacarpal firstproximalphalange firstdistalphalange",
            Fingers = "second third fourth fifth",
            Joints = "*metacarpal *proximalphalange *middlephalange *distalphalange",
        },
        new() // Xsens, BVH
        {
            Spine = "chest chest2 chest3 chest4",
            Leg = "hip knee ankle",
            Arm = "collar shoulder elbow wrist",
        },
        new() // Rokoko
        {
            Spine = "spine1 spine2 spine3 spine4",
            Leg = "thigh shin foot",
            Arm = "shoulder arm forearm hand",
            Thumb = "finger1metacarpal finger1proximal finger1distal",
            Fingers = "finger2 finger3 finger4 finger5",
            Joints = "*metacarpal *proximal *medial *distal",
        },
    ];

    private static readonly RigNames[] Neck1Rows = [Own, .. OtherRigs];

    private static readonly RigNames[] Spine3Rows = [OwnSpine3, .. OtherRigs];

    // The stream's own names come first, so that they win if others fit equally well.
    public static IReadOnlyList<RigNames> Rows(SkeletonVariant variant) => variant == SkeletonVariant.Spine3 ? Spine3Rows : Neck1Rows;
}
