using System.Numerics;

namespace NeuronMocap.Skeleton;

/// <summary>
/// The rest pose of the default body: a T-pose with every rotation zero and arms along X (manual, Appendix B).
/// </summary>
/// <remarks>
/// Positions are in centimetres, relative to the parent. Axes are right-handed, with Y up, X to the subject's left and Z forward. The body of a
/// server has other lengths. Only a stream with displacement carries them.
/// </remarks>
public static class DefaultOffsets
{
    private static readonly Vector3[] Neck1Offsets =
    [
        new(0, 84.102f, 0), // Hips
        new(-9.5f, -0f, 0), // RightUpLeg; the sign of zero is the manual's
        new(0, -37.051f, 0), // RightLeg
        new(0, -37.051f, 0), // RightFoot
        new(9.5f, -0f, 0), // LeftUpLeg
        new(0, -37.051f, 0), // LeftLeg
        new(0, -37.051f, 0), // LeftFoot
        new(0, 7.14f, 0), // Spine
        new(0, 15.81f, 0), // Spine1
        new(0, 11.22f, 0), // Spine2
        new(0, 16.83f, 0), // Neck
        new(0, 4.5f, 0), // Neck1
        new(0, 4.5f, 0), // Head
        new(-2.55f, 11.73f, 0), // RightShoulder
        new(-11.45f, 0, 0), // RightArm
        new(-25, 0, 0), // RightForeArm
        new(-25, 0, 0), // RightHand
        new(-2.418f, 0.185f, 3.031f), // RightHandThumb1
        new(-3.578f, 0, 0), // RightHandThumb2
        new(-2.485f, 0, 0), // RightHandThumb3
        new(-3.132f, 0.494f, 1.922f), // RightInHandIndex
        new(-5.068f, -0.089f, 0.971f), // RightHandIndex1
        new(-3.516f, 0, 0), // RightHandIndex2
        new(-1.993f, 0, 0), // RightHandIndex3
        new(-3.285f, 0.502f, 0.735f), // RightInHandMiddle
        new(-5.026f, -0.082f, 0.305f), // RightHandMiddle1
        new(-3.837f, 0, 0), // RightHandMiddle2
        new(-2.405f, 0, 0), // RightHandMiddle3
        new(-3.269f, 0.523f, -0.125f), // RightInHandRing
        new(-4.502f, -0.021f, -0.465f), // RightHandRing1
        new(-3.344f, 0, 0), // RightHandRing2
        new(-2.32f, 0, 0), // RightHandRing3
        new(-3.071f, 0.456f, -1.167f), // RightInHandPinky
        new(-4.023f, -0.021f, -1.059f), // RightHandPinky1
        new(-2.678f, 0, 0), // RightHandPinky2
        new(-1.692f, 0, 0), // RightHandPinky3
        new(2.55f, 11.73f, 0), // LeftShoulder
        new(11.45f, 0, 0), // LeftArm
        new(25, 0, 0), // LeftForeArm
        new(25, 0, 0), // LeftHand
        new(2.418f, 0.185f, 3.031f), // LeftHandThumb1
        new(3.578f, 0, 0), // LeftHandThumb2
        new(2.485f, 0, 0), // LeftHandThumb3
        new(3.132f, 0.494f, 1.922f), // LeftInHandIndex
        new(5.068f, -0.089f, 0.971f), // LeftHandIndex1
        new(3.516f, 0, 0), // LeftHandIndex2
        new(1.993f, 0, 0), // LeftHandIndex3
        new(3.285f, 0.502f, 0.735f), // LeftInHandMiddle
        new(5.026f, -0.082f, 0.305f), // LeftHandMiddle1
        new(3.837f, 0, 0), // LeftHandMiddle2
        new(2.405f, 0, 0), // LeftHandMiddle3
        new(3.269f, 0.523f, -0.125f), // LeftInHandRing
        new(4.502f, -0.021f, -0.465f), // LeftHandRing1
        new(3.344f, 0, 0), // LeftHandRing2
        new(2.32f, 0, 0), // LeftHandRing3
        new(3.071f, 0.456f, -1.167f), // LeftInHandPinky
        new(4.023f, -0.021f, -1.059f), // LeftHandPinky1
        new(2.678f, 0, 0), // LeftHandPinky2
        new(1.692f, 0, 0), // LeftHandPinky3
    ];

    /// <summary>Gets the position of a bone relative to its parent. For the hips, it is their height above the ground.</summary>
    /// <param name="bone">The bone.</param>
    /// <param name="variant">
    /// The variant of the spine. The manual gives offsets only for the Neck1 variant. The offsets of Spine3 divide the same stature in the
    /// proportions of real takes of that variant. Head and shoulders are thus at the same place in both variants.
    /// </param>
    /// <returns>Centimetres, in the parent's axes.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The bone is not defined.</exception>
    public static Vector3 Get(Bone bone, SkeletonVariant variant = SkeletonVariant.Neck1)
    {
        Vector3 offset = Neck1Offsets[BoneHierarchy.CheckedIndex(bone)];
        return variant == SkeletonVariant.Spine3 ? GetSpine3(bone, offset) : offset;
    }

    /// <summary>Gets the end of a bone without children, relative to the bone: the End Site of a BVH file.</summary>
    /// <param name="bone">The bone.</param>
    /// <param name="offset">Receives the End Site in centimetres, in the bone's axes. Zero for a bone that has children.</param>
    /// <returns>False for a bone that has children.</returns>
    public static bool TryGetEndSite(Bone bone, out Vector3 offset)
    {
        offset = bone switch
        {
            Bone.RightFoot => new Vector3(0, -10, 15.75f),
            Bone.LeftFoot => new Vector3(0, -10, 15.75f),
            Bone.Head => new Vector3(0, 17, 0),
            Bone.RightHandThumb3 => new Vector3(-2.131f, 0, 0),
            Bone.RightHandIndex3 => new Vector3(-1.754f, 0, 0),
            Bone.RightHandMiddle3 => new Vector3(-1.918f, 0, 0),
            Bone.RightHandRing3 => new Vector3(-1.804f, 0, 0),
            Bone.RightHandPinky3 => new Vector3(-1.598f, 0, 0),
            Bone.LeftHandThumb3 => new Vector3(2.131f, 0, 0),
            Bone.LeftHandIndex3 => new Vector3(1.754f, 0, 0),
            Bone.LeftHandMiddle3 => new Vector3(1.918f, 0, 0),
            Bone.LeftHandRing3 => new Vector3(1.804f, 0, 0),
            Bone.LeftHandPinky3 => new Vector3(1.598f, 0, 0),
            _ => Vector3.Zero,
        };
        return offset != Vector3.Zero;
    }

    // The sums are the same as in the other variant: 60 cm from hips to head, and 45.9 cm from hips to shoulders.
    private static Vector3 GetSpine3(Bone bone, Vector3 offset) => bone switch
    {
        Bone.Spine => new Vector3(0, 13.47f, 0),
        Bone.Spine1 => new Vector3(0, 9.15f, 0),
        Bone.Spine2 => new Vector3(0, 9.53f, 0),
        Bone.Neck => new Vector3(0, 9.15f, 0),
        Bone.Neck1 => new Vector3(0, 9.78f, 0),
        Bone.Head => new Vector3(0, 8.92f, 0),
        Bone.RightShoulder or Bone.LeftShoulder => new Vector3(offset.X, 4.6f, 0),
        _ => offset,
    };
}
