using System.Numerics;

namespace NeuronMocap.Skeleton;

/// <summary>
/// The sizes of an actor: the offset of each of the 59 bones from its parent, and the ends of the outermost bones. A stream without displacement
/// carries only rotations; the body provides the bone lengths. Immutable and thread-safe.
/// </summary>
public sealed class SkeletonBody
{
    private static readonly SkeletonBody Neck1 = CreateDefault(SkeletonVariant.Neck1);
    private static readonly SkeletonBody Spine3 = CreateDefault(SkeletonVariant.Spine3);

    private readonly Vector3[] _offsets;
    private readonly Vector3[] _endSites;

    /// <summary>Creates a body of known sizes, such as those of a BVH hierarchy.</summary>
    /// <param name="offsets">
    /// Offsets of the 59 bones from their parents, in <see cref="Bone"/> order, in centimetres. The offset of the hips is from the origin.
    /// </param>
    /// <param name="endSites">
    /// The End Sites of the bones without children, relative to their bone, as 59 values in <see cref="Bone"/> order. Values of other bones are
    /// ignored. If empty, <see cref="DefaultOffsets.TryGetEndSite"/> is used.
    /// </param>
    /// <param name="variant">Determines the parent of the shoulders.</param>
    /// <exception cref="ArgumentException">There are fewer than 59 offsets, or from 1 to 58 End Sites.</exception>
    public SkeletonBody(
        ReadOnlySpan<Vector3> offsets,
        ReadOnlySpan<Vector3> endSites = default,
        SkeletonVariant variant = SkeletonVariant.Neck1)
    {
        if (offsets.Length < BoneHierarchy.BoneCount)
            throw new ArgumentException("There must be an offset for each of the 59 bones.", nameof(offsets));
        if (endSites.Length is > 0 and < BoneHierarchy.BoneCount)
            throw new ArgumentException("There must be an End Site for each of the 59 bones, or none at all.", nameof(endSites));

        Variant = variant;
        _offsets = offsets[..BoneHierarchy.BoneCount].ToArray();
        _endSites = new Vector3[BoneHierarchy.BoneCount];
        foreach (Bone bone in JointPositions.EndSiteBones)
        {
            DefaultOffsets.TryGetEndSite(bone, out Vector3 end);
            _endSites[(int)bone] = endSites.IsEmpty ? end : endSites[(int)bone];
        }
    }

    /// <summary>Gets the variant, which determines the parent of the shoulders and the division of the neck.</summary>
    public SkeletonVariant Variant { get; }

    /// <summary>Gets the offsets of the 59 bones from their parents at rest, in <see cref="Bone"/> order, in centimetres.</summary>
    public ReadOnlySpan<Vector3> Offsets => _offsets;

    /// <summary>
    /// Gets the End Sites of the bones without children, relative to their bone, in <see cref="Bone"/> order, in centimetres. Zero for all others.
    /// </summary>
    public ReadOnlySpan<Vector3> EndSites => _endSites;

    /// <summary>Gets the default body, made of <see cref="DefaultOffsets"/>.</summary>
    /// <param name="variant">Determines the parent of the shoulders.</param>
    /// <returns>The body; the same object on every call for a variant.</returns>
    public static SkeletonBody GetDefault(SkeletonVariant variant = SkeletonVariant.Neck1) =>
        variant == SkeletonVariant.Spine3 ? Spine3 : Neck1;

    /// <summary>
    /// Stretches the default body to an actor's sizes, as the command channel sends them. <see cref="Measure"/> returns the same sizes.
    /// </summary>
    /// <remarks>
    /// Lengths that the twelve sizes do not cover follow their part of the body. The height of the shoulders follows the spine, and the
    /// fingers follow the palm. The hips are as high as the legs are long.
    /// </remarks>
    /// <param name="dimensions">The sizes.</param>
    /// <param name="variant">Determines the parent of the shoulders.</param>
    /// <returns>The body.</returns>
    /// <exception cref="ArgumentException">A size is negative, infinite or not a number.</exception>
    public static SkeletonBody FromDimensions(in BoneDimensions dimensions, SkeletonVariant variant = SkeletonVariant.Neck1) =>
        BodyScaling.Create(dimensions, variant);

    /// <summary>Creates the body from a pose with the actor's own positions: a pose of a take, or of a stream with displacement.</summary>
    /// <param name="pose">59 transforms relative to the parent, in <see cref="Bone"/> order. Only the positions are used.</param>
    /// <param name="variant">Determines the parent of the shoulders.</param>
    /// <param name="endSites">End Sites as in the constructor; no stream carries them.</param>
    /// <returns>A body whose hips are above the origin, as high as the legs are long.</returns>
    /// <exception cref="ArgumentException">There are fewer than 59 transforms, or from 1 to 58 End Sites.</exception>
    public static SkeletonBody FromPose(
        ReadOnlySpan<BoneTransform> pose,
        SkeletonVariant variant = SkeletonVariant.Neck1,
        ReadOnlySpan<Vector3> endSites = default)
    {
        ForwardKinematics.CheckPose(pose, nameof(pose));
        Span<Vector3> offsets = stackalloc Vector3[BoneHierarchy.BoneCount];
        for (int bone = 0; bone < offsets.Length; bone++)
            offsets[bone] = pose[bone].Position;

        return Standing(offsets, endSites, variant);
    }

    /// <summary>Gets the offset of a bone from its parent at rest.</summary>
    /// <param name="bone">The bone.</param>
    /// <returns>Centimetres, in the parent's axes.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The bone is not defined.</exception>
    public Vector3 GetOffset(Bone bone) => _offsets[BoneHierarchy.CheckedIndex(bone)];

    /// <summary>Writes the rest pose: every rotation is zero, the arms are along X.</summary>
    /// <param name="pose">Receives 59 transforms relative to the parent.</param>
    /// <exception cref="ArgumentException">There is no room for 59 transforms.</exception>
    public void CopyRestPose(Span<BoneTransform> pose)
    {
        ForwardKinematics.CheckRoom(pose, nameof(pose));
        for (int bone = 0; bone < _offsets.Length; bone++)
            pose[bone] = new BoneTransform(_offsets[bone], Quaternion.Identity);
    }

    /// <summary>Measures the body's twelve sizes, in metres, by <see cref="BoneDimensions.Measure"/>.</summary>
    /// <returns>The sizes.</returns>
    public BoneDimensions Measure()
    {
        Span<BoneTransform> pose = stackalloc BoneTransform[BoneHierarchy.BoneCount];
        CopyRestPose(pose);
        return BoneDimensions.Measure(pose, Variant, _endSites);
    }

    // Puts the body on the ground, whatever the height of its hips was.
    internal static SkeletonBody Standing(Span<Vector3> offsets, ReadOnlySpan<Vector3> endSites, SkeletonVariant variant)
    {
        offsets[(int)Bone.Hips] = Vector3.Zero;
        var body = new SkeletonBody(offsets, endSites, variant);
        Span<BoneTransform> rest = stackalloc BoneTransform[BoneHierarchy.BoneCount];
        body.CopyRestPose(rest);
        ForwardKinematics.ToWorld(rest, rest, variant);
        body._offsets[(int)Bone.Hips] = new Vector3(0, -JointPositions.GetLowest(rest, body).Y, 0);
        return body;
    }

    private static SkeletonBody CreateDefault(SkeletonVariant variant) =>
        new([.. BoneHierarchy.Bones.ToArray().Select(bone => DefaultOffsets.Get(bone, variant))], default, variant);
}
