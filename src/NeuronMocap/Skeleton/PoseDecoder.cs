using System.Numerics;

namespace NeuronMocap.Skeleton;

/// <summary>
/// Converts the values of a BVH frame to the transforms of the bones. It converts all angles at once, which is several times as fast as bone by bone.
/// Allocates nothing; thread-safe.
/// </summary>
public static class PoseDecoder
{
    // 59 bones, rounded up to whole vectors.
    private const int Room = 64;

    /// <summary>Computes the transforms of all bones relative to their parents.</summary>
    /// <param name="values">
    /// The values of a motion packet, or of a row of a BVH file in the same order. Positions are in centimetres, angles of any size in
    /// degrees.
    /// </param>
    /// <param name="layout">The layout of the values.</param>
    /// <param name="order">The order of the angles.</param>
    /// <param name="body">Provides the positions that the values do not carry.</param>
    /// <param name="local">Receives 59 transforms, in <see cref="Bone"/> order.</param>
    /// <exception cref="ArgumentException">There are fewer values than the layout has, or no room for 59 transforms.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The rotation order is not defined.</exception>
    public static void Decode(
        ReadOnlySpan<float> values,
        ChannelLayout layout,
        RotationOrder order,
        SkeletonBody body,
        Span<BoneTransform> local)
    {
        ArgumentNullException.ThrowIfNull(body);
        ForwardKinematics.CheckRoom(local, nameof(local));
        if (values.Length < layout.ValueCount)
            throw new ArgumentException($"A frame of this layout must have {layout.ValueCount} values, not {values.Length}.", nameof(values));

        var turn = new RotationComposer(order);
        Span<float> degrees = stackalloc float[3 * Room];
        Span<float> sines = stackalloc float[3 * Room];
        Span<float> cosines = stackalloc float[3 * Room];
        int stride = layout.HasDisplacement ? 6 : 3;
        ReadOnlySpan<float> angles = values[layout.GetRotationIndex(Bone.Hips)..];
        for (int bone = 0; bone < BoneHierarchy.BoneCount; bone++)
        {
            ReadOnlySpan<float> three = angles.Slice(bone * stride, 3);
            degrees[(3 * bone) + 2] = three[2];
            degrees[(3 * bone) + 1] = three[1];
            degrees[3 * bone] = three[0];
        }

        HalfAngles.SinCos(degrees, sines, cosines);
        ReadOnlySpan<Vector3> offsets = body.Offsets;
        ReadOnlySpan<float> positions = values[layout.GetPositionIndex(Bone.Hips)..];
        for (int bone = 0; bone < BoneHierarchy.BoneCount; bone++)
        {
            Vector3 position = layout.HasDisplacement || bone == 0 ? Read(positions, bone * stride) : offsets[bone];
            local[bone] = new BoneTransform(position, turn.Compose(Read(sines, 3 * bone), Read(cosines, 3 * bone)));
        }
    }

    private static Vector3 Read(ReadOnlySpan<float> values, int index)
    {
        ReadOnlySpan<float> three = values.Slice(index, 3);
        return new Vector3(three[0], three[1], three[2]);
    }
}
