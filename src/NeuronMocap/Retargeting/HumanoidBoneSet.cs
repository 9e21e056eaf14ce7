namespace NeuronMocap.Retargeting;

/// <summary>A set of Humanoid bones, such as the bones of a rig.</summary>
public readonly record struct HumanoidBoneSet
{
    private readonly ulong _bits;

    private HumanoidBoneSet(ulong bits) => _bits = bits;

    /// <summary>Gets the set of all 55 bones.</summary>
    public static HumanoidBoneSet All => new((1UL << HumanoidBones.Count) - 1);

    /// <summary>Gets the number of bones in the set.</summary>
    public int Count
    {
        get
        {
            int count = 0;
            for (ulong rest = _bits; rest != 0; rest &= rest - 1)
                count++;

            return count;
        }
    }

    /// <summary>Determines whether a bone is in the set.</summary>
    /// <param name="bone">The bone.</param>
    /// <returns>True if the set contains the bone; false otherwise, and for undefined values.</returns>
    public bool Contains(HumanoidBone bone) => (uint)bone < HumanoidBones.Count && (_bits & Bit(bone)) != 0;

    /// <summary>Returns a set that also contains a bone.</summary>
    /// <param name="bone">The bone.</param>
    /// <returns>The new set.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The bone is not defined.</exception>
    public HumanoidBoneSet With(HumanoidBone bone) => new(_bits | Bit(bone));

    /// <summary>Returns a set without a bone.</summary>
    /// <param name="bone">The bone.</param>
    /// <returns>The new set.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The bone is not defined.</exception>
    public HumanoidBoneSet Without(HumanoidBone bone) => new(_bits & ~Bit(bone));

    private static ulong Bit(HumanoidBone bone) => 1UL << HumanoidBones.CheckedIndex(bone);
}
