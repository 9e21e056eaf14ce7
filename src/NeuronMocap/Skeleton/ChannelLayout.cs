namespace NeuronMocap.Skeleton;

/// <summary>
/// Where the values of a BVH frame stand: manual section 1.2.1, protocol.md section 3.1. Two settings of the server make four layouts:
/// <list type="table">
/// <item><term>180</term><description>displacement off, reference off: position of the hips, then three rotations for every bone</description></item>
/// <item><term>186</term><description>displacement off, reference on: six values of the Reference node first</description></item>
/// <item><term>354</term><description>displacement on, reference off: position and rotation of every bone</description></item>
/// <item><term>360</term><description>displacement on, reference on</description></item>
/// </list>
/// Positions are centimetres, X Y Z; rotations are degrees, in the order of the server's <see cref="RotationOrder"/>.
/// </summary>
public readonly record struct ChannelLayout
{
    private const int ReferenceValues = 6;

    /// <summary>Makes the layout of two settings.</summary>
    /// <param name="hasDisplacement">Whether every bone carries a position, not only the hips.</param>
    /// <param name="hasReference">Whether the Reference node comes first.</param>
    public ChannelLayout(bool hasDisplacement, bool hasReference)
    {
        HasDisplacement = hasDisplacement;
        HasReference = hasReference;
    }

    /// <summary>Whether every bone carries a position, not only the hips.</summary>
    public bool HasDisplacement { get; }

    /// <summary>Whether the Reference node's position and rotation come first.</summary>
    public bool HasReference { get; }

    /// <summary>Number of values of a frame: 180, 186, 354 or 360.</summary>
    public int ValueCount =>
        FirstBone + (HasDisplacement ? BoneHierarchy.BoneCount * 6 : 3 + (BoneHierarchy.BoneCount * 3));

    private int FirstBone => HasReference ? ReferenceValues : 0;

    /// <summary>Finds the layout that a number of values can only belong to.</summary>
    /// <param name="valueCount">Number of values of a frame.</param>
    /// <param name="layout">The layout, when there is one.</param>
    /// <returns>False for any number but the four.</returns>
    public static bool TryFromValueCount(int valueCount, out ChannelLayout layout)
    {
        layout = valueCount switch
        {
            186 => new ChannelLayout(hasDisplacement: false, hasReference: true),
            354 => new ChannelLayout(hasDisplacement: true, hasReference: false),
            360 => new ChannelLayout(hasDisplacement: true, hasReference: true),
            _ => default,
        };
        return layout.ValueCount == valueCount;
    }

    /// <summary>Index of the first of the three position values of a bone.</summary>
    /// <param name="bone">A bone.</param>
    /// <returns>An index, or -1 when the frame does not carry a position of that bone.</returns>
    /// <exception cref="ArgumentOutOfRangeException">There is no such bone.</exception>
    public int GetPositionIndex(Bone bone)
    {
        int index = BoneHierarchy.CheckedIndex(bone);
        if (HasDisplacement)
            return FirstBone + (index * 6);

        return index == 0 ? FirstBone : -1;
    }

    /// <summary>Index of the first of the three rotation values of a bone.</summary>
    /// <param name="bone">A bone.</param>
    /// <returns>An index.</returns>
    /// <exception cref="ArgumentOutOfRangeException">There is no such bone.</exception>
    public int GetRotationIndex(Bone bone)
    {
        int index = BoneHierarchy.CheckedIndex(bone);
        return FirstBone + 3 + (index * (HasDisplacement ? 6 : 3));
    }
}
