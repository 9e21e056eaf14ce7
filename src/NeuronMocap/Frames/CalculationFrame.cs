using System.Diagnostics;
using System.Numerics;
using NeuronMocap.Frames;
using NeuronMocap.Protocol;
using NeuronMocap.Skeleton;

namespace NeuronMocap;

/// <summary>
/// Sensor readings and global positions of one avatar at one instant, from the calculation stream (manual section 1.2.2, protocol.md
/// section 3.3). Bones stand in another order than in the BVH stream, and two contact flags stand between body and fingers; the members
/// here take care of both. For how long a frame is valid, see <see cref="AvatarFrame"/>.
/// </summary>
public sealed class CalculationFrame : AvatarFrame
{
    /// <summary>Number of values of a frame of 21 bones, as before b15.</summary>
    public const int BodyValueCount = (CalculationOrder.BodyBoneCount * ValuesPerBone) + ContactCount;

    /// <summary>Number of values of a frame of 59 bones.</summary>
    public const int FullValueCount = (BoneHierarchy.BoneCount * ValuesPerBone) + ContactCount;

    private const int ValuesPerBone = 16;
    private const int ContactCount = 2;
    private const int LeftContact = CalculationOrder.BodyBoneCount * ValuesPerBone;
    private const int RightContact = LeftContact + 1;

    /// <summary>Makes a frame that owns its memory: to test code that takes frames, or to feed one from another source.</summary>
    /// <param name="header">The header; its count is replaced by the number of values.</param>
    /// <param name="values">The values in wire order; copied.</param>
    public CalculationFrame(in CalculationHeader header, ReadOnlySpan<float> values)
    {
        byte[] packet = new byte[(header with { ValueCount = values.Length }).PacketSize];
        PacketEncoder.WriteCalculation(packet, header, values);
        Borrow(new ReceivedPacket(PacketKind.Calculation, packet, Stopwatch.GetTimestamp(), origin: 0));
    }

    internal CalculationFrame()
    {
    }

    /// <summary>All fields of the packet's header, reserved ones included.</summary>
    public CalculationHeader Header => CalculationHeader.Read(_data.Header);

    /// <inheritdoc/>
    public override int AvatarIndex => (int)CalculationHeader.ReadAvatarIndex(_data.Header);

    /// <inheritdoc/>
    public override string AvatarName => AvatarNames.GetText(CalculationHeader.ReadAvatarName(_data.Header));

    /// <inheritdoc/>
    public override uint? FrameIndex => CalculationHeader.ReadFrameIndex(_data.Header);

    /// <summary>
    /// How many bones the frame carries: 59, or 21 without the fingers, or 0 when the number of values is neither 338 nor 946; then only
    /// <see cref="AvatarFrame.Values"/> and the header are of use.
    /// </summary>
    public int BoneCount => _data.ValueCount switch
    {
        FullValueCount => BoneHierarchy.BoneCount,
        BodyValueCount => CalculationOrder.BodyBoneCount,
        _ => 0,
    };

    /// <summary>Whether the left foot touches the ground.</summary>
    /// <exception cref="InvalidOperationException">The frame carries no bones.</exception>
    public bool LeftFootContact => ReadContact(LeftContact);

    /// <summary>Whether the right foot touches the ground.</summary>
    /// <exception cref="InvalidOperationException">The frame carries no bones.</exception>
    public bool RightFootContact => ReadContact(RightContact);

    /// <summary>Which feet touch the ground.</summary>
    /// <exception cref="InvalidOperationException">The frame carries no bones.</exception>
    public FootContacts FootContacts => new(LeftFootContact, RightFootContact);

    /// <summary>Whether the frame carries a bone: the fingers are missing from the short form.</summary>
    /// <param name="bone">A bone.</param>
    /// <returns>Whether the other members can be asked for it.</returns>
    /// <exception cref="ArgumentOutOfRangeException">There is no such bone.</exception>
    public bool Contains(Bone bone) => CalculationOrder.IndexOf(bone) < BoneCount;

    /// <summary>Position of a bone's centre in the world.</summary>
    /// <param name="bone">A bone.</param>
    /// <returns>Metres, in the axes that the server is set to.</returns>
    /// <exception cref="InvalidOperationException">The frame does not carry the bone.</exception>
    /// <exception cref="ArgumentOutOfRangeException">There is no such bone.</exception>
    public Vector3 GetPosition(Bone bone) => ReadVector(bone, 0);

    /// <summary>Velocity of a bone in the world.</summary>
    /// <param name="bone">A bone.</param>
    /// <returns>Metres per second, in the axes that the server is set to.</returns>
    /// <exception cref="InvalidOperationException">The frame does not carry the bone.</exception>
    /// <exception cref="ArgumentOutOfRangeException">There is no such bone.</exception>
    public Vector3 GetVelocity(Bone bone) => ReadVector(bone, 3);

    /// <summary>Rotation of a bone's sensor in the world. It is not the bone's: sensors sit on a bone at any angle.</summary>
    /// <param name="bone">A bone.</param>
    /// <returns>The quaternion as received; the stream's order is w x y z.</returns>
    /// <exception cref="InvalidOperationException">The frame does not carry the bone.</exception>
    /// <exception cref="ArgumentOutOfRangeException">There is no such bone.</exception>
    public Quaternion GetSensorRotation(Bone bone)
    {
        ReadOnlySpan<float> values = Values.Slice(IndexOf(bone) + 6, 4);
        return new Quaternion(values[1], values[2], values[3], values[0]);
    }

    /// <summary>Acceleration measured by a bone's sensor.</summary>
    /// <param name="bone">A bone.</param>
    /// <returns>
    /// Multiples of gravity, in the sensor's own axes: 1 g downwards at rest. The manual does not give the unit; Axis Neuron's exports show it.
    /// </returns>
    /// <exception cref="InvalidOperationException">The frame does not carry the bone.</exception>
    /// <exception cref="ArgumentOutOfRangeException">There is no such bone.</exception>
    public Vector3 GetAcceleration(Bone bone) => ReadVector(bone, 10);

    /// <summary>Angular velocity measured by a bone's sensor.</summary>
    /// <param name="bone">A bone.</param>
    /// <returns>Radians per second, in the sensor's own axes. The manual does not give the unit; Axis Neuron's exports show it.</returns>
    /// <exception cref="InvalidOperationException">The frame does not carry the bone.</exception>
    /// <exception cref="ArgumentOutOfRangeException">There is no such bone.</exception>
    public Vector3 GetAngularVelocity(Bone bone) => ReadVector(bone, 13);

    /// <summary>Makes a copy that owns its memory and stays valid.</summary>
    /// <returns>A frame equal to this one, time of receipt included.</returns>
    public CalculationFrame Clone()
    {
        var clone = new CalculationFrame();
        clone.CopyFrom(this);
        return clone;
    }

    private Vector3 ReadVector(Bone bone, int field)
    {
        ReadOnlySpan<float> values = Values.Slice(IndexOf(bone) + field, 3);
        return new Vector3(values[0], values[1], values[2]);
    }

    private bool ReadContact(int index) =>
        BoneCount > 0 ? Values[index] != 0 : throw new InvalidOperationException("The frame carries no bones; see BoneCount.");

    // The manual's plain i * 16 is wrong behind the body: the two contact flags stand before the fingers (protocol.md section 3.3).
    private int IndexOf(Bone bone)
    {
        int index = CalculationOrder.IndexOf(bone);
        if (index >= BoneCount)
            throw new InvalidOperationException($"The frame carries {BoneCount} bones, {bone} is not among them; see Contains.");

        return (index * ValuesPerBone) + (index < CalculationOrder.BodyBoneCount ? 0 : ContactCount);
    }
}
