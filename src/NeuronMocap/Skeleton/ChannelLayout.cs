namespace NeuronMocap.Skeleton;

/// <summary>
/// The position of the values in a BVH frame (manual section 1.2.1, protocol.md section 3.1). Two settings of the server give four layouts:
/// <list type="table">
/// <item><term>180</term><description>displacement off, reference off: the position of the hips, then three rotation values for every
/// bone</description></item>
/// <item><term>186</term><description>displacement off, reference on: six values of the Reference node first</description></item>
/// <item><term>354</term><description>displacement on, reference off: position and rotation of every bone</description></item>
/// <item><term>360</term><description>displacement on, reference on</description></item>
/// </list>
/// Positions are X, Y, Z in centimetres. Rotations are in degrees, in the server's <see cref="RotationOrder"/>.
/// </summary>
public readonly record struct ChannelLayout
{
    private const int ReferenceValues = 6;

    /// <summary>Creates the layout for two settings.</summary>
    /// <param name="hasDisplacement">Whether every bone carries a position, not only the hips.</param>
    /// <param name="hasReference">Whether the Reference node comes first.</param>
    public ChannelLayout(bool hasDisplacement, bool hasReference)
    {
        HasDisplacement = hasDisplacement;
        HasReference = hasReference;
    }

    /// <summary>Gets whether every bone carries a position, not only the hips.</summary>
    public bool HasDisplacement { get; }

    /// <summary>Gets whether the Reference node's position and rotation come first.</summary>
    public bool HasReference { get; }

    /// <summary>Gets the number of values of a frame: 180, 186, 354 or 360.</summary>
    public int ValueCount =>
        FirstBone + (HasDisplacement ? BoneHierarchy.BoneCount * 6 : 3 + (BoneHierarchy.BoneCount * 3));

    private int FirstBone => HasReference ? ReferenceValues : 0;

    /// <summary>Finds the layout with a number of values.</summary>
    /// <param name="valueCount">Number of values of a frame.</param>
    /// <param name="layout">Receives the layout, if one has that number of values.</param>
    /// <returns>False for any number except the four.</returns>
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

    /// <summary>Gets the index of the first of the three position values of a bone.</summary>
    /// <param name="bone">The bone.</param>
    /// <returns>An index, or -1 if the frame does not carry the position of that bone.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The bone is not defined.</exception>
    public int GetPositionIndex(Bone bone)
    {
        int index = BoneHierarchy.CheckedIndex(bone);
        if (HasDisplacement)
            return FirstBone + (index * 6);

        return index == 0 ? FirstBone : -1;
    }

    /// <summary>Gets the index of the first of the three rotation values of a bone.</summary>
    /// <param name="bone">The bone.</param>
    /// <returns>An index.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The bone is not defined.</exception>
    public int GetRotationIndex(Bone bone)
    {
        int index = BoneHierarchy.CheckedIndex(bone);
        return FirstBone + 3 + (index * (HasDisplacement ? 6 : 3));
    }
}
