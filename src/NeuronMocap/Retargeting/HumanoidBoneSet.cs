namespace NeuronMocap.Retargeting;

/// <summary>A set of Humanoid bones, such as those that a rig has.</summary>
public readonly record struct HumanoidBoneSet
{
    private readonly ulong _bits;

    private HumanoidBoneSet(ulong bits) => _bits = bits;

    /// <summary>All 55.</summary>
    public static HumanoidBoneSet All => new((1UL << HumanoidBones.Count) - 1);

    /// <summary>How many there are.</summary>
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

    /// <summary>Whether a bone is in the set.</summary>
    /// <param name="bone">A bone.</param>
    /// <returns>False, too, for what is no bone.</returns>
    public bool Contains(HumanoidBone bone) => (uint)bone < HumanoidBones.Count && (_bits & Bit(bone)) != 0;

    /// <summary>The set with one bone more.</summary>
    /// <param name="bone">A bone.</param>
    /// <returns>Another set.</returns>
    /// <exception cref="ArgumentOutOfRangeException">There is no such bone.</exception>
    public HumanoidBoneSet With(HumanoidBone bone) => new(_bits | Bit(bone));

    /// <summary>The set with one bone less.</summary>
    /// <param name="bone">A bone.</param>
    /// <returns>Another set.</returns>
    /// <exception cref="ArgumentOutOfRangeException">There is no such bone.</exception>
    public HumanoidBoneSet Without(HumanoidBone bone) => new(_bits & ~Bit(bone));

    private static ulong Bit(HumanoidBone bone) => 1UL << HumanoidBones.CheckedIndex(bone);
}
