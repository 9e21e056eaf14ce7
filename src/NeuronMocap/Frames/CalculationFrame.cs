using System.Diagnostics;
using System.Numerics;
using NeuronMocap.Frames;
using NeuronMocap.Protocol;
using NeuronMocap.Skeleton;

namespace NeuronMocap;

/// <summary>
/// Sensor readings and global positions of one avatar at one moment, from the calculation stream (manual section 1.2.2, protocol.md section 3.3).
/// </summary>
/// <remarks>
/// The bones are in another order than in the BVH stream, and two contact flags lie between body and fingers. The members of this class handle both.
/// <see cref="AvatarFrame"/> describes how long a frame is valid.
/// </remarks>
public sealed class CalculationFrame : AvatarFrame
{
    /// <summary>Number of values in a frame of 21 bones, the form before b15.</summary>
    public const int BodyValueCount = (CalculationOrder.BodyBoneCount * ValuesPerBone) + ContactCount;

    /// <summary>Number of values in a frame of 59 bones.</summary>
    public const int FullValueCount = (BoneHierarchy.BoneCount * ValuesPerBone) + ContactCount;

    private const int ValuesPerBone = 16;
    private const int ContactCount = 2;
    private const int LeftContact = CalculationOrder.BodyBoneCount * ValuesPerBone;
    private const int RightContact = LeftContact + 1;

    /// <summary>Makes a frame that owns its memory. Use it to test code that takes frames, or to provide frames from another source.</summary>
    /// <param name="header">The header; its count is replaced by the number of values.</param>
    /// <param name="values">The values in stream order; copied.</param>
    public CalculationFrame(in CalculationHeader header, ReadOnlySpan<float> values)
    {
        byte[] packet = new byte[(header with { ValueCount = values.Length }).PacketSize];
        PacketEncoder.WriteCalculation(packet, header, values);
        Borrow(new ReceivedPacket(PacketKind.Calculation, packet, Stopwatch.GetTimestamp(), origin: 0));
    }

    internal CalculationFrame()
    {
    }

    /// <summary>All fields of the packet's header, including reserved fields.</summary>
    public CalculationHeader Header => CalculationHeader.Read(_data.Header);

    /// <inheritdoc/>
    public override int AvatarIndex => (int)CalculationHeader.ReadAvatarIndex(_data.Header);

    /// <inheritdoc/>
    public override string AvatarName => AvatarNames.GetText(CalculationHeader.ReadAvatarName(_data.Header));

    /// <inheritdoc/>
    public override uint? FrameIndex => CalculationHeader.ReadFrameIndex(_data.Header);

    /// <summary>
    /// Number of bones in the frame: 59, or 21 without the fingers. It is 0 if the number of values is neither 338 nor 946. Then only
    /// <see cref="AvatarFrame.Values"/> and the header are useful.
    /// </summary>
    public int BoneCount => _data.ValueCount switch
    {
        FullValueCount => BoneHierarchy.BoneCount,
        BodyValueCount => CalculationOrder.BodyBoneCount,
        _ => 0,
    };

    /// <summary>Whether the left foot touches the ground.</summary>
    /// <exception cref="InvalidOperationException">The frame contains no bones.</exception>
    public bool LeftFootContact => ReadContact(LeftContact);

    /// <summary>Whether the right foot touches the ground.</summary>
    /// <exception cref="InvalidOperationException">The frame contains no bones.</exception>
    public bool RightFootContact => ReadContact(RightContact);

    /// <summary>Which feet touch the ground.</summary>
    /// <exception cref="InvalidOperationException">The frame contains no bones.</exception>
    public FootContacts FootContacts => new(LeftFootContact, RightFootContact);

    /// <summary>Determines whether the frame contains a bone. The short form has no fingers.</summary>
    /// <param name="bone">A bone.</param>
    /// <returns>True if the other members accept the bone.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The bone does not exist.</exception>
    public bool Contains(Bone bone) => CalculationOrder.IndexOf(bone) < BoneCount;

    /// <summary>Gets the position of a bone's centre in the world.</summary>
    /// <param name="bone">A bone.</param>
    /// <returns>Metres, in the axes set on the server.</returns>
    /// <exception cref="InvalidOperationException">The frame does not contain the bone.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The bone does not exist.</exception>
    public Vector3 GetPosition(Bone bone) => ReadVector(bone, 0);

    /// <summary>Gets the velocity of a bone in the world.</summary>
    /// <param name="bone">A bone.</param>
    /// <returns>Metres per second, in the axes set on the server.</returns>
    /// <exception cref="InvalidOperationException">The frame does not contain the bone.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The bone does not exist.</exception>
    public Vector3 GetVelocity(Bone bone) => ReadVector(bone, 3);

    /// <summary>
    /// Gets the rotation of a bone's sensor in the world. The bone itself has another rotation, because a sensor can sit on it at any angle.
    /// </summary>
    /// <param name="bone">A bone.</param>
    /// <returns>The quaternion as received; the order in the stream is w x y z.</returns>
    /// <exception cref="InvalidOperationException">The frame does not contain the bone.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The bone does not exist.</exception>
    public Quaternion GetSensorRotation(Bone bone)
    {
        ReadOnlySpan<float> values = Values.Slice(IndexOf(bone) + 6, 4);
        return new Quaternion(values[1], values[2], values[3], values[0]);
    }

    /// <summary>Gets the acceleration that a bone's sensor measures.</summary>
    /// <param name="bone">A bone.</param>
    /// <returns>
    /// Multiples of gravity, in the sensor's own axes: 1 g downwards at rest. The manual does not specify the unit; the exports of Axis Neuron show it.
    /// </returns>
    /// <exception cref="InvalidOperationException">The frame does not contain the bone.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The bone does not exist.</exception>
    public Vector3 GetAcceleration(Bone bone) => ReadVector(bone, 10);

    /// <summary>Gets the angular velocity that a bone's sensor measures.</summary>
    /// <param name="bone">A bone.</param>
    /// <returns>Radians per second, in the sensor's own axes. The manual does not specify the unit; the exports of Axis Neuron show it.</returns>
    /// <exception cref="InvalidOperationException">The frame does not contain the bone.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The bone does not exist.</exception>
    public Vector3 GetAngularVelocity(Bone bone) => ReadVector(bone, 13);

    /// <summary>Makes a copy that owns its memory and stays valid.</summary>
    /// <returns>A frame equal to this one, including its time of receipt.</returns>
    public new CalculationFrame Clone()
    {
        var clone = new CalculationFrame();
        clone.CopyFrom(this);
        return clone;
    }

    private protected override AvatarFrame CreateClone() => Clone();

    private Vector3 ReadVector(Bone bone, int field)
    {
        ReadOnlySpan<float> values = Values.Slice(IndexOf(bone) + field, 3);
        return new Vector3(values[0], values[1], values[2]);
    }

    private bool ReadContact(int index) =>
        BoneCount > 0 ? Values[index] != 0 : throw new InvalidOperationException("The frame contains no bones; see BoneCount.");

    // The manual's i * 16 is wrong after the body, because the two contact flags come before the fingers (protocol.md section 3.3).
    private int IndexOf(Bone bone)
    {
        int index = CalculationOrder.IndexOf(bone);
        if (index >= BoneCount)
            throw new InvalidOperationException($"The frame contains {BoneCount} bones, but not {bone}; see Contains.");

        return (index * ValuesPerBone) + (index < CalculationOrder.BodyBoneCount ? 0 : ContactCount);
    }
}
