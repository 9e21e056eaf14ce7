using System.Buffers.Binary;
using System.Numerics;

namespace NeuronMocap.Skeleton;

/// <summary>
/// The twelve sizes of an actor's body, in metres, as the command channel sends them (manual section 2.1.8, protocol.md section 2.4). The manual
/// names the sizes but does not define the points between which they lie. <see cref="Measure"/> documents its own definitions.
/// </summary>
public readonly record struct BoneDimensions
{
    /// <summary>Bytes on the wire.</summary>
    public const int Size = Count * sizeof(float);

    private const int Count = 12;
    private const float CentimetresPerMetre = 100;

    /// <summary>Length of the head, in metres.</summary>
    public float Head { get; init; }

    /// <summary>Length of the neck, in metres.</summary>
    public float Neck { get; init; }

    /// <summary>Length of the body, in metres.</summary>
    public float Body { get; init; }

    /// <summary>Width of the shoulders, in metres.</summary>
    public float ShoulderWidth { get; init; }

    /// <summary>Length of an upper arm, in metres.</summary>
    public float UpperArm { get; init; }

    /// <summary>Length of a forearm, in metres.</summary>
    public float Forearm { get; init; }

    /// <summary>Length of a hand, in metres.</summary>
    public float Palm { get; init; }

    /// <summary>Width of the hips, in metres.</summary>
    public float HipWidth { get; init; }

    /// <summary>Length of a thigh, in metres.</summary>
    public float UpperLeg { get; init; }

    /// <summary>Length of a shin, in metres.</summary>
    public float LowerLeg { get; init; }

    /// <summary>Height of the heel, in metres.</summary>
    public float HeelHeight { get; init; }

    /// <summary>Length of a foot, in metres.</summary>
    public float FootLength { get; init; }

    /// <summary>
    /// Measures a body. Only positions are used, so any pose of the body gives the same sizes. Sizes of two sides are averaged.
    /// <list type="table">
    /// <item><term><see cref="Head"/></term><description>joint of the head to its End Site</description></item>
    /// <item><term><see cref="Neck"/></term><description>lowest joint named Neck to the joint of the head, along the bones</description></item>
    /// <item><term><see cref="Body"/></term><description>hips to that joint, along the bones of the spine</description></item>
    /// <item><term><see cref="ShoulderWidth"/></term><description>joint of one upper arm to that of the other, all rotations zero</description></item>
    /// <item><term><see cref="UpperArm"/></term><description>joint of the upper arm to that of the forearm</description></item>
    /// <item><term><see cref="Forearm"/></term><description>joint of the forearm to that of the hand</description></item>
    /// <item><term><see cref="Palm"/></term><description>joint of the hand to the first joint of the middle finger, all rotations zero</description></item>
    /// <item><term><see cref="HipWidth"/></term><description>joint of one thigh to that of the other</description></item>
    /// <item><term><see cref="UpperLeg"/></term><description>joint of the thigh to that of the shin</description></item>
    /// <item><term><see cref="LowerLeg"/></term><description>joint of the shin to that of the foot</description></item>
    /// <item><term><see cref="HeelHeight"/></term><description>joint of the foot to its End Site, vertically</description></item>
    /// <item><term><see cref="FootLength"/></term><description>joint of the foot to its End Site, horizontally</description></item>
    /// </list>
    /// </summary>
    /// <param name="pose">59 transforms relative to the parent, in <see cref="Bone"/> order, in centimetres.</param>
    /// <param name="variant">Determines where the neck begins.</param>
    /// <param name="endSites">
    /// The End Sites of the bones without children, relative to their bone, as 59 values in <see cref="Bone"/> order. Values of other bones are
    /// ignored. If empty, <see cref="DefaultOffsets.TryGetEndSite"/> is used, because no stream carries End Sites.
    /// </param>
    /// <returns>The sizes.</returns>
    /// <exception cref="ArgumentException">There are fewer than 59 transforms, or from 1 to 58 End Sites.</exception>
    public static BoneDimensions Measure(
        ReadOnlySpan<BoneTransform> pose,
        SkeletonVariant variant = SkeletonVariant.Neck1,
        ReadOnlySpan<Vector3> endSites = default)
    {
        if (pose.Length < BoneHierarchy.BoneCount)
            throw new ArgumentException("There must be a transform for each of the 59 bones.", nameof(pose));
        if (endSites.Length is > 0 and < BoneHierarchy.BoneCount)
            throw new ArgumentException("There must be an End Site for each of the 59 bones, or none at all.", nameof(endSites));

        Bone neck = variant == SkeletonVariant.Spine3 ? Bone.Neck1 : Bone.Neck;
        Vector3 rightFoot = EndSite(Bone.RightFoot, endSites);
        Vector3 leftFoot = EndSite(Bone.LeftFoot, endSites);
        return new BoneDimensions
        {
            Head = EndSite(Bone.Head, endSites).Length() / CentimetresPerMetre,
            Neck = Along(pose, neck + 1, Bone.Head),
            Body = Along(pose, Bone.Spine, neck),
            ShoulderWidth = Width(
                Place(pose, Bone.RightShoulder) + Place(pose, Bone.RightArm),
                Place(pose, Bone.LeftShoulder) + Place(pose, Bone.LeftArm)),
            UpperArm = Mean(Place(pose, Bone.RightForeArm).Length(), Place(pose, Bone.LeftForeArm).Length()),
            Forearm = Mean(Place(pose, Bone.RightHand).Length(), Place(pose, Bone.LeftHand).Length()),
            Palm = Mean(
                (Place(pose, Bone.RightInHandMiddle) + Place(pose, Bone.RightHandMiddle1)).Length(),
                (Place(pose, Bone.LeftInHandMiddle) + Place(pose, Bone.LeftHandMiddle1)).Length()),
            HipWidth = Width(Place(pose, Bone.RightUpLeg), Place(pose, Bone.LeftUpLeg)),
            UpperLeg = Mean(Place(pose, Bone.RightLeg).Length(), Place(pose, Bone.LeftLeg).Length()),
            LowerLeg = Mean(Place(pose, Bone.RightFoot).Length(), Place(pose, Bone.LeftFoot).Length()),
            HeelHeight = Mean(MathF.Abs(rightFoot.Y), MathF.Abs(leftFoot.Y)),
            FootLength = Mean(Horizontal(rightFoot), Horizontal(leftFoot)),
        };
    }

    /// <summary>Reads the sizes from the wire: twelve floats in the order of the members.</summary>
    /// <param name="source">At least 48 bytes. Further bytes are ignored.</param>
    /// <param name="dimensions">Receives the sizes if they are valid.</param>
    /// <returns>False if there are fewer than 48 bytes, or if a size is negative, infinite or not a number.</returns>
    public static bool TryRead(ReadOnlySpan<byte> source, out BoneDimensions dimensions)
    {
        dimensions = default;
        if (source.Length < Size)
            return false;

        Span<float> sizes = stackalloc float[Count];
        for (int i = 0; i < Count; i++)
        {
            sizes[i] = BitConverter.Int32BitsToSingle(BinaryPrimitives.ReadInt32LittleEndian(source[(i * sizeof(float))..]));
            if (!(sizes[i] >= 0) || float.IsInfinity(sizes[i]))
                return false;
        }

        dimensions = new BoneDimensions
        {
            Head = sizes[0],
            Neck = sizes[1],
            Body = sizes[2],
            ShoulderWidth = sizes[3],
            UpperArm = sizes[4],
            Forearm = sizes[5],
            Palm = sizes[6],
            HipWidth = sizes[7],
            UpperLeg = sizes[8],
            LowerLeg = sizes[9],
            HeelHeight = sizes[10],
            FootLength = sizes[11],
        };
        return true;
    }

    /// <summary>Writes the sizes in wire format.</summary>
    /// <param name="destination">A span of at least 48 bytes.</param>
    /// <exception cref="ArgumentException">The span is too short.</exception>
    public void Write(Span<byte> destination)
    {
        if (destination.Length < Size)
            throw new ArgumentException("There must be room for 48 bytes.", nameof(destination));

        ReadOnlySpan<float> sizes =
        [
            Head, Neck, Body, ShoulderWidth, UpperArm, Forearm, Palm, HipWidth, UpperLeg, LowerLeg, HeelHeight, FootLength,
        ];
        for (int i = 0; i < Count; i++)
            BinaryPrimitives.WriteInt32LittleEndian(destination[(i * sizeof(float))..], BitConverter.SingleToInt32Bits(sizes[i]));
    }

    private static Vector3 Place(ReadOnlySpan<BoneTransform> pose, Bone bone) => pose[(int)bone].Position;

    private static Vector3 EndSite(Bone bone, ReadOnlySpan<Vector3> endSites)
    {
        if (endSites.Length > 0)
            return endSites[(int)bone];

        DefaultOffsets.TryGetEndSite(bone, out Vector3 end);
        return end;
    }

    private static float Along(ReadOnlySpan<BoneTransform> pose, Bone first, Bone last)
    {
        float length = 0;
        for (Bone bone = first; bone <= last; bone++)
            length += Place(pose, bone).Length();

        return length / CentimetresPerMetre;
    }

    private static float Width(Vector3 right, Vector3 left) => (left - right).Length() / CentimetresPerMetre;

    private static float Horizontal(Vector3 offset) => new Vector2(offset.X, offset.Z).Length();

    private static float Mean(float right, float left) => (right + left) / 2 / CentimetresPerMetre;
}
