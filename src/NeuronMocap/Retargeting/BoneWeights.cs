using NeuronMocap.Skeleton;

namespace NeuronMocap.Retargeting;

/// <summary>
/// Says how much of the actor's motion each bone takes over, from 0 to 1.
/// </summary>
/// <remarks>
/// The effective weight is the weight of the body part times the weight of the bone. All weights are 1 at first. A joint of weight 0.5 bends half as
/// far as the actor's; its children keep their own bend relative to it. A bone of weight 0 is not driven (<see cref="RetargetedPose.IsDriven"/>), so
/// an animation or a headset may move it. Not thread-safe.
/// </remarks>
public sealed class BoneWeights
{
    private const int PartCount = 9;

    private readonly float[] _parts = new float[PartCount];
    private readonly float[] _humanoid = new float[HumanoidBones.Count];
    private readonly float[] _bones = new float[BoneHierarchy.BoneCount];

    /// <summary>Creates weights that are all 1.</summary>
    public BoneWeights() => Reset();

    /// <summary>Gets or sets the weight of a bone of a Humanoid rig, not including the weight of its body part.</summary>
    /// <param name="bone">The bone.</param>
    /// <exception cref="ArgumentOutOfRangeException">The bone is not defined, or the weight is not between 0 and 1.</exception>
    public float this[HumanoidBone bone]
    {
        get => _humanoid[HumanoidBones.CheckedIndex(bone)];
        set => _humanoid[HumanoidBones.CheckedIndex(bone)] = Checked(value);
    }

    /// <summary>Gets or sets the weight of a bone of a generic rig, not including the weight of its body part.</summary>
    /// <param name="bone">The bone.</param>
    /// <exception cref="ArgumentOutOfRangeException">The bone is not defined, or the weight is not between 0 and 1.</exception>
    public float this[Bone bone]
    {
        get => _bones[BoneHierarchy.CheckedIndex(bone)];
        set => _bones[BoneHierarchy.CheckedIndex(bone)] = Checked(value);
    }

    /// <summary>Creates a mask: the given parts have weight 1, all others weight 0.</summary>
    /// <param name="parts">The parts to drive.</param>
    /// <returns>New weights.</returns>
    public static BoneWeights Only(BodyParts parts)
    {
        var weights = new BoneWeights();
        weights.SetPart(BodyParts.All & ~parts, 0);
        return weights;
    }

    /// <summary>Creates the mask for a headset that turns the head. Every bone except the head is driven, including the neck.</summary>
    /// <returns>New weights.</returns>
    public static BoneWeights WithoutHead() => new() { [HumanoidBone.Head] = 0, [Bone.Head] = 0 };

    /// <summary>Sets every weight to 1.</summary>
    public void Reset()
    {
        Array.Fill(_parts, 1);
        Array.Fill(_humanoid, 1);
        Array.Fill(_bones, 1);
    }

    /// <summary>Sets the weight of one or more parts of the body.</summary>
    /// <param name="parts">The parts.</param>
    /// <param name="weight">From 0 to 1.</param>
    /// <exception cref="ArgumentOutOfRangeException">The weight is not between 0 and 1.</exception>
    public void SetPart(BodyParts parts, float weight)
    {
        Checked(weight);
        for (int part = 0; part < PartCount; part++)
        {
            if (((int)parts & (1 << part)) != 0)
                _parts[part] = weight;
        }
    }

    /// <summary>Gets the weight of a part of the body.</summary>
    /// <param name="part">One of the nine parts.</param>
    /// <returns>From 0 to 1.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The value is not a single part.</exception>
    public float GetPart(BodyParts part) => _parts[PartIndex(part)];

    internal static int PartIndex(BodyParts part)
    {
        for (int i = 0; i < PartCount; i++)
        {
            if ((int)part == 1 << i)
                return i;
        }

        throw new ArgumentOutOfRangeException(nameof(part), part, "The value must be one of the nine parts of the body.");
    }

    internal float OfHumanoid(int part, int bone) => _parts[part] * _humanoid[bone];

    internal float OfBone(int part, int bone) => _parts[part] * _bones[bone];

    private static float Checked(float weight) => weight is >= 0 and <= 1
        ? weight
        : throw new ArgumentOutOfRangeException(nameof(weight), weight, "The weight must be a number from 0 to 1.");
}
