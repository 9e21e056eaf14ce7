using System.Diagnostics.CodeAnalysis;
using System.Numerics;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Bvh;

/// <summary>
/// Neuron's 59 bones in a BVH file: which joint each of them is, and where its values stand. The joints may come in any order and among
/// others; names and parents have to be those of one <see cref="SkeletonVariant"/>. The hips are a root, or hang from a root named Reference.
/// Immutable; thread-safe.
/// </summary>
public sealed class BvhSkeletonMap
{
    internal const string ReferenceName = "Reference";

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
    }

    /// <summary>The file; without rows where the map was made of a hierarchy.</summary>
    public BvhDocument Document { get; }

    /// <summary>Naming of the bones, from the joints' names, and order of the rotation values, from their channels.</summary>
    public SkeletonFormat Format { get; }

    /// <summary>
    /// The motion packet that the file's values fill: 354 when every bone has position channels, 180 when only the hips have; six more
    /// where the hips hang from a Reference node, whose values come first.
    /// </summary>
    public ChannelLayout Layout { get; }

    /// <summary>The joint of a bone.</summary>
    /// <param name="bone">A bone.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such bone.</exception>
    public BvhJoint this[Bone bone] => (uint)bone < BoneHierarchy.BoneCount
        ? _joints[(int)bone]
        : throw new ArgumentOutOfRangeException(nameof(bone), bone, "The bone must be one of the 59 bones, 0 to 58.");

    /// <summary>The body that the file's hierarchy describes: its OFFSETs and End Sites. A leaf without End Site ends at its joint.</summary>
    /// <returns>A body of the file's own <see cref="SkeletonVariant"/>; centimetres, as the file's own unit is taken to be.</returns>
    public SkeletonBody GetBody() => _body;

    /// <summary>Finds the bones in a file.</summary>
    /// <param name="document">The file.</param>
    /// <param name="map">The bones, when all are there.</param>
    /// <param name="reason">When not: the first thing that is missing or different, in English.</param>
    /// <returns>False when the file's skeleton is not Neuron's.</returns>
    public static bool TryCreate(
        BvhDocument document,
        [NotNullWhen(true)] out BvhSkeletonMap? map,
        [NotNullWhen(false)] out string? reason)
    {
        ArgumentNullException.ThrowIfNull(document);
        map = null;
        bool hasSpine3 = document.Joints.Any(joint => joint.Name is "Spine3");
        SkeletonVariant variant = hasSpine3 ? SkeletonVariant.Spine3 : SkeletonVariant.Neck1;
        if (!TryFindJoints(document, variant, out BvhJoint[] joints, out reason))
            return false;

        var columns = new BvhBoneColumns(joints, joints[(int)Bone.Hips].Parent);
        if (!columns.TryRead(out reason))
            return false;

        var format = new SkeletonFormat(columns.RotationOrder, variant);
        map = new BvhSkeletonMap(document, joints, columns.Indices, columns.Layout, format);
        return true;
    }

    /// <summary>Finds the bones in a hierarchy, for rows that are read one by one: <see cref="BvhReader.Hierarchy"/>.</summary>
    /// <param name="hierarchy">The joints.</param>
    /// <param name="map">The bones, when all are there.</param>
    /// <param name="reason">When not: the first thing that is missing or different, in English.</param>
    /// <returns>False when the skeleton is not Neuron's.</returns>
    public static bool TryCreate(
        BvhHierarchy hierarchy,
        [NotNullWhen(true)] out BvhSkeletonMap? map,
        [NotNullWhen(false)] out string? reason) => TryCreate(new BvhDocument(hierarchy, BvhFrameTime.Default, []), out map, out reason);

    /// <summary>Writes a row as the values of a motion packet of <see cref="Layout"/>, bit for bit those of the file.</summary>
    /// <param name="frame">Number of the frame, from 0.</param>
    /// <param name="destination">Room for <see cref="ChannelLayout.ValueCount"/> values.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such frame.</exception>
    /// <exception cref="ArgumentException">The destination is too short.</exception>
    public void CopyValues(int frame, Span<float> destination) => CopyValues(Document.GetFrame(frame), destination);

    /// <summary>Writes a row as the values of a motion packet of <see cref="Layout"/>, bit for bit.</summary>
    /// <param name="row">The row, of all channels of the hierarchy.</param>
    /// <param name="destination">Room for <see cref="ChannelLayout.ValueCount"/> values.</param>
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
    /// Writes the transforms of all bones relative to their parents, of the hips to the Reference node where there is one
    /// (<see cref="GetReference(int)"/>). A position is that of the row where it has one, else the joint's <see cref="BvhJoint.Offset"/>.
    /// </summary>
    /// <param name="frame">Number of the frame, from 0.</param>
    /// <param name="destination">Room for 59, in <see cref="Bone"/> order; centimetres, as the file's own unit is taken to be.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such frame.</exception>
    /// <exception cref="ArgumentException">The destination is too short.</exception>
    public void CopyLocalTransforms(int frame, Span<BoneTransform> destination) => CopyLocalTransforms(Document.GetFrame(frame), destination);

    /// <summary>Writes the transforms of all bones in a row; otherwise as by the number of a frame.</summary>
    /// <param name="row">The row, of all channels of the hierarchy.</param>
    /// <param name="destination">Room for 59, in <see cref="Bone"/> order; centimetres, as the file's own unit is taken to be.</param>
    /// <exception cref="ArgumentException">The row or the destination is too short.</exception>
    public void CopyLocalTransforms(ReadOnlySpan<float> row, Span<BoneTransform> destination)
    {
        Span<float> values = stackalloc float[Layout.ValueCount];
        CopyValues(row, values);
        PoseDecoder.Decode(values, Layout, Format.RotationOrder, _body, destination);
    }

    /// <summary>The transform that the hips are relative to.</summary>
    /// <param name="frame">Number of the frame, from 0.</param>
    /// <returns>That of the Reference node, or none where the file has no such node; centimetres.</returns>
    /// <exception cref="ArgumentOutOfRangeException">There is no such frame.</exception>
    public BoneTransform GetReference(int frame) => GetReference(Document.GetFrame(frame));

    /// <summary>The transform that the hips are relative to.</summary>
    /// <param name="row">The row, of all channels of the hierarchy.</param>
    /// <returns>That of the Reference node, or none where the file has no such node; centimetres.</returns>
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
        SkeletonVariant variant,
        out BvhJoint[] joints,
        [NotNullWhen(false)] out string? reason)
    {
        joints = new BvhJoint[BoneHierarchy.BoneCount];
        foreach (BvhJoint joint in document.Joints)
        {
            if (!BoneHierarchy.TryFind(joint.Name, variant, out Bone bone))
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
            reason ??= FindFault(joints, bone, variant, document.Joints[0]);

        return reason is null;
    }

    private static string? FindFault(BvhJoint?[] joints, Bone bone, SkeletonVariant variant, BvhJoint root)
    {
        string name = BoneHierarchy.GetName(bone, variant);
        if (joints[(int)bone] is not { } joint)
            return $"The file has no joint named {name}; its first joint is named {root.Name}.";

        Bone? parent = BoneHierarchy.GetParent(bone, variant);
        string? expected = parent is { } known ? BoneHierarchy.GetName(known, variant) : null;
        if (string.Equals(joint.Parent?.Name, expected, StringComparison.Ordinal) || (parent is null && IsReference(joint.Parent)))
            return null;

        return $"The parent of joint {name} must be {NameOf(expected)}, not {NameOf(joint.Parent?.Name)}.";
    }

    private static bool IsReference(BvhJoint? joint) => joint is { Parent: null, Name: ReferenceName };

    private static string NameOf(string? parent) => parent ?? "nothing";

    private void CheckRow(ReadOnlySpan<float> row)
    {
        if (row.Length < Document.ChannelCount)
            throw new ArgumentException($"A row has {Document.ChannelCount} values, not {row.Length}.", nameof(row));
    }

    private Vector3 ReadVector(ReadOnlySpan<float> row, int index) =>
        new(row[_columns[index]], row[_columns[index + 1]], row[_columns[index + 2]]);
}
