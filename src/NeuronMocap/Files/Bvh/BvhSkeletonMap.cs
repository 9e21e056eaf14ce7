using System.Diagnostics.CodeAnalysis;
using System.Numerics;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Bvh;

/// <summary>
/// Finds the 59 Neuron bones in a BVH file: the joint of each bone and the position of its values in a row. Immutable; thread-safe.
/// </summary>
/// <remarks>
/// The joints may have any order, and the file may have other joints. Names and parents must be those of one <see cref="SkeletonVariant"/>. The
/// hips must be a root, or a child of a root named Reference. All names can have the same prefix, such as <c>Robot:</c>, that ends with neither a letter
/// nor a digit.
/// </remarks>
public sealed class BvhSkeletonMap
{
    private readonly BvhJoint[] _joints;
    private readonly int[] _columns;
    private readonly SkeletonBody _body;

    private BvhSkeletonMap(BvhDocument document, BvhJoint[] joints, int[] columns, ChannelLayout layout, SkeletonFormat format)
    {
        Document = document;
        _joints = joints;
        _columns = columns;
        Layout = layout;
        Format = format;
        _body = MakeBody(joints, format.Variant);
        BvhJoint? reference = joints[(int)Bone.Hips].Parent;
        OtherJoints = [.. document.Joints.Except(joints).Where(joint => joint != reference)];
    }

    /// <summary>The file. It has no rows if the map was created from a hierarchy.</summary>
    public BvhDocument Document { get; }

    /// <summary>The names of the bones and the order of the rotation values.</summary>
    public SkeletonFormat Format { get; }

    /// <summary>
    /// The layout of a motion packet with the file's values. It has 354 values when every bone has position channels, and 180 when only the hips
    /// have them. A Reference node above the hips adds six values, which come first.
    /// </summary>
    public ChannelLayout Layout { get; }

    /// <summary>The joints of the file that are neither one of the bones nor the Reference node, such as props. Poses do not have them.</summary>
    public IReadOnlyList<BvhJoint> OtherJoints { get; }

    /// <summary>Gets the joint of a bone.</summary>
    /// <param name="bone">The bone.</param>
    /// <exception cref="ArgumentOutOfRangeException">The bone is not defined.</exception>
    public BvhJoint this[Bone bone] => (uint)bone < BoneHierarchy.BoneCount
        ? _joints[(int)bone]
        : throw new ArgumentOutOfRangeException(nameof(bone), bone, "The bone must be one of the 59 bones, 0 to 58.");

    /// <summary>Gets the body that the hierarchy describes: its OFFSETs and End Sites. A leaf without an End Site ends at its joint.</summary>
    /// <returns>A body of the file's <see cref="SkeletonVariant"/>. The file's unit is assumed to be centimetres.</returns>
    public SkeletonBody GetBody() => _body;

    /// <summary>Finds the bones in a file.</summary>
    /// <param name="document">The file.</param>
    /// <param name="map">The bones, if all were found.</param>
    /// <param name="reason">Otherwise: the first bone that is missing or different, in English.</param>
    /// <returns>True if the file has the Neuron skeleton.</returns>
    public static bool TryCreate(
        BvhDocument document,
        [NotNullWhen(true)] out BvhSkeletonMap? map,
        [NotNullWhen(false)] out string? reason)
    {
        ArgumentNullException.ThrowIfNull(document);
        map = null;
        var names = BvhBoneNames.Find(document.Joints);
        if (!TryFindJoints(document, names, out BvhJoint[] joints, out reason))
            return false;

        var columns = new BvhBoneColumns(joints, joints[(int)Bone.Hips].Parent);
        if (!columns.TryRead(out reason))
            return false;

        var format = new SkeletonFormat(columns.RotationOrder, names.Variant);
        map = new BvhSkeletonMap(document, joints, columns.Indices, columns.Layout, format);
        return true;
    }

    /// <summary>Finds the bones in a hierarchy, for reading row by row: <see cref="BvhReader.Hierarchy"/>.</summary>
    /// <param name="hierarchy">The joints.</param>
    /// <param name="map">The bones, if all were found.</param>
    /// <param name="reason">Otherwise: the first bone that is missing or different, in English.</param>
    /// <returns>True if the hierarchy has the Neuron skeleton.</returns>
    public static bool TryCreate(
        BvhHierarchy hierarchy,
        [NotNullWhen(true)] out BvhSkeletonMap? map,
        [NotNullWhen(false)] out string? reason) => TryCreate(new BvhDocument(hierarchy, BvhFrameTime.Default, []), out map, out reason);

    /// <summary>Copies a frame as the values of a motion packet of <see cref="Layout"/>, bit for bit.</summary>
    /// <param name="frame">Number of the frame, from 0.</param>
    /// <param name="destination">Receives <see cref="ChannelLayout.ValueCount"/> values.</param>
    /// <exception cref="ArgumentOutOfRangeException">The frame does not exist.</exception>
    /// <exception cref="ArgumentException">The destination is too short.</exception>
    public void CopyValues(int frame, Span<float> destination) => CopyValues(Document.GetValues(frame), destination);

    /// <summary>Copies a row as the values of a motion packet of <see cref="Layout"/>, bit for bit.</summary>
    /// <param name="row">The row, with all channels of the hierarchy.</param>
    /// <param name="destination">Receives <see cref="ChannelLayout.ValueCount"/> values.</param>
    /// <exception cref="ArgumentException">The row or the destination is too short.</exception>
    public void CopyValues(ReadOnlySpan<float> row, Span<float> destination)
    {
        CheckRow(row);
        if (destination.Length < _columns.Length)
            throw new ArgumentException($"There must be room for {_columns.Length} values.", nameof(destination));

        for (int i = 0; i < _columns.Length; i++)
            destination[i] = row[_columns[i]];
    }

    /// <summary>
    /// Copies the transforms of all bones relative to their parents. Those of the hips are relative to the Reference node, if the file has one
    /// (<see cref="GetReference(int)"/>). A joint without position channels has the position <see cref="BvhJoint.Offset"/>.
    /// </summary>
    /// <param name="frame">Number of the frame, from 0.</param>
    /// <param name="destination">Receives 59 transforms in <see cref="Bone"/> order. The file's unit is assumed to be centimetres.</param>
    /// <exception cref="ArgumentOutOfRangeException">The frame does not exist.</exception>
    /// <exception cref="ArgumentException">The destination is too short.</exception>
    public void CopyLocalTransforms(int frame, Span<BoneTransform> destination) => CopyLocalTransforms(Document.GetValues(frame), destination);

    /// <summary>
    /// Copies the transforms of all bones in a row, as <see cref="CopyLocalTransforms(int, Span{BoneTransform})"/> does for a frame.
    /// </summary>
    /// <param name="row">The row, with all channels of the hierarchy.</param>
    /// <param name="destination">Receives 59 transforms in <see cref="Bone"/> order. The file's unit is assumed to be centimetres.</param>
    /// <exception cref="ArgumentException">The row or the destination is too short.</exception>
    public void CopyLocalTransforms(ReadOnlySpan<float> row, Span<BoneTransform> destination)
    {
        Span<float> values = stackalloc float[Layout.ValueCount];
        CopyValues(row, values);
        PoseDecoder.Decode(values, Layout, Format.RotationOrder, _body, destination);
    }

    /// <summary>Gets the transform that the hips are relative to.</summary>
    /// <param name="frame">Number of the frame, from 0.</param>
    /// <returns>The transform of the Reference node, or the identity if the file does not have one; centimetres.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The frame does not exist.</exception>
    public BoneTransform GetReference(int frame) => GetReference(Document.GetValues(frame));

    /// <summary>Gets the transform that the hips are relative to.</summary>
    /// <param name="row">The row, with all channels of the hierarchy.</param>
    /// <returns>The transform of the Reference node, or the identity if the file does not have one; centimetres.</returns>
    /// <exception cref="ArgumentException">The row is too short.</exception>
    public BoneTransform GetReference(ReadOnlySpan<float> row)
    {
        CheckRow(row);
        return Layout.HasReference
            ? new BoneTransform(ReadVector(row, 0), EulerAngles.ToQuaternion(ReadVector(row, 3), Format.RotationOrder))
            : BoneTransform.Identity;
    }

    private static SkeletonBody MakeBody(BvhJoint[] joints, SkeletonVariant variant)
    {
        Vector3[] offsets = [.. joints.Select(static joint => joint.Offset)];
        Vector3[] endSites = [.. joints.Select(static joint => joint.EndSite ?? Vector3.Zero)];
        return new SkeletonBody(offsets, endSites, variant);
    }

    private static bool TryFindJoints(
        BvhDocument document,
        BvhBoneNames names,
        out BvhJoint[] joints,
        [NotNullWhen(false)] out string? reason)
    {
        joints = new BvhJoint[BoneHierarchy.BoneCount];
        foreach (BvhJoint joint in document.Joints)
        {
            if (!names.TryFind(joint, out Bone bone))
                continue;

            if (joints[(int)bone] is not null)
            {
                reason = $"There are two joints named {joint.Name}.";
                return false;
            }

            joints[(int)bone] = joint;
        }

        reason = null;
        foreach (Bone bone in BoneHierarchy.Bones)
            reason ??= FindFault(joints, bone, names, document.Joints[0]);

        return reason is null;
    }

    private static string? FindFault(BvhJoint?[] joints, Bone bone, BvhBoneNames names, BvhJoint root)
    {
        if (joints[(int)bone] is not { } joint)
            return $"The file has no joint named {names[bone]}; its first joint is named {root.Name}.";

        Bone? parent = BoneHierarchy.GetParent(bone, names.Variant);
        BvhJoint? expected = parent is { } known ? joints[(int)known] : null;
        if (joint.Parent == expected || (parent is null && BvhBoneNames.IsReference(joint.Parent)))
            return null;

        return $"The parent of joint {joint.Name} must be {expected?.Name ?? "nothing"}, not {joint.Parent?.Name ?? "nothing"}.";
    }

    private void CheckRow(ReadOnlySpan<float> row)
    {
        if (row.Length < Document.ChannelCount)
            throw new ArgumentException($"A row must have {Document.ChannelCount} values, not {row.Length}.", nameof(row));
    }

    private Vector3 ReadVector(ReadOnlySpan<float> row, int index) =>
        new(row[_columns[index]], row[_columns[index + 1]], row[_columns[index + 2]]);
}
