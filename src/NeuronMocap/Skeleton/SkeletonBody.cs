using System.Numerics;

namespace NeuronMocap.Skeleton;

/// <summary>
/// The sizes of an actor: where each of the 59 bones is relative to its parent, and where the outermost bones end. A stream without
/// displacement carries rotations only; a body says what they turn. Immutable; thread-safe.
/// </summary>
public sealed class SkeletonBody
{
    private static readonly SkeletonBody Neck1 = CreateDefault(SkeletonVariant.Neck1);
    private static readonly SkeletonBody Spine3 = CreateDefault(SkeletonVariant.Spine3);

    private readonly Vector3[] _offsets;
    private readonly Vector3[] _endSites;

    /// <summary>Makes a body of known sizes, as a BVH hierarchy has them.</summary>
    /// <param name="offsets">Places of the 59 bones relative to their parents, in <see cref="Bone"/> order, of the hips above the origin; centimetres.</param>
    /// <param name="endSites">
    /// Where the bones end that have no children, relative to them, in <see cref="Bone"/> order, 59 of them; those of other bones have no meaning.
    /// Empty: <see cref="DefaultOffsets.TryGetEndSite"/>.
    /// </param>
    /// <param name="variant">Decides where the shoulders hang.</param>
    /// <exception cref="ArgumentException">There are fewer than 59 offsets, or End Sites but fewer than 59.</exception>
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

    /// <summary>Where the shoulders hang, and how the neck is divided.</summary>
    public SkeletonVariant Variant { get; }

    /// <summary>Places of the 59 bones relative to their parents at rest, in <see cref="Bone"/> order; centimetres.</summary>
    public ReadOnlySpan<Vector3> Offsets => _offsets;

    /// <summary>Where the bones end that have no children, relative to them, in <see cref="Bone"/> order; zero for all others. Centimetres.</summary>
    public ReadOnlySpan<Vector3> EndSites => _endSites;

    /// <summary>The default body: <see cref="DefaultOffsets"/>.</summary>
    /// <param name="variant">Where the shoulders hang.</param>
    /// <returns>Always the same object for a variant.</returns>
    public static SkeletonBody GetDefault(SkeletonVariant variant = SkeletonVariant.Neck1) =>
        variant == SkeletonVariant.Spine3 ? Spine3 : Neck1;

    /// <summary>
    /// The default body, stretched to an actor's sizes, as the command channel tells them. <see cref="Measure"/> gives the sizes back. What the twelve
    /// sizes do not say follows its part of the body: the shoulders' height the spine, the fingers the palm. The hips are as high as the legs are long.
    /// </summary>
    /// <param name="dimensions">The sizes.</param>
    /// <param name="variant">Where the shoulders hang.</param>
    /// <returns>A body.</returns>
    /// <exception cref="ArgumentException">A size is negative, infinite or not a number.</exception>
    public static SkeletonBody FromDimensions(in BoneDimensions dimensions, SkeletonVariant variant = SkeletonVariant.Neck1) =>
        BodyScaling.Create(dimensions, variant);

    /// <summary>The body behind a pose whose positions are an actor's own: one of a stream with displacement, or of a take.</summary>
    /// <param name="pose">59 transforms relative to the parent, in <see cref="Bone"/> order; only the positions count.</param>
    /// <param name="variant">Where the shoulders hang.</param>
    /// <param name="endSites">As in the constructor: no stream carries them.</param>
    /// <returns>A body whose hips are as high as the legs are long, above the origin.</returns>
    /// <exception cref="ArgumentException">There are fewer than 59 transforms, or End Sites but fewer than 59.</exception>
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

    /// <summary>The place of a bone relative to its parent at rest.</summary>
    /// <param name="bone">A bone.</param>
    /// <returns>Centimetres, in the parent's axes.</returns>
    /// <exception cref="ArgumentOutOfRangeException">There is no such bone.</exception>
    public Vector3 GetOffset(Bone bone) => _offsets[BoneHierarchy.CheckedIndex(bone)];

    /// <summary>Writes the body at rest: every rotation zero, arms along X.</summary>
    /// <param name="pose">Receives 59 transforms relative to the parent.</param>
    /// <exception cref="ArgumentException">There is less room.</exception>
    public void CopyRestPose(Span<BoneTransform> pose)
    {
        ForwardKinematics.CheckRoom(pose, nameof(pose));
        for (int bone = 0; bone < _offsets.Length; bone++)
            pose[bone] = new BoneTransform(_offsets[bone], Quaternion.Identity);
    }

    /// <summary>The body's twelve sizes, in metres: <see cref="BoneDimensions.Measure"/>.</summary>
    /// <returns>The sizes.</returns>
    public BoneDimensions Measure()
    {
        Span<BoneTransform> pose = stackalloc BoneTransform[BoneHierarchy.BoneCount];
        CopyRestPose(pose);
        return BoneDimensions.Measure(pose, Variant, _endSites);
    }

    // Stands the body on the ground, whatever its hips were at.
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
