using System.Diagnostics;
using System.Numerics;
using NeuronMocap.Frames;
using NeuronMocap.Protocol;
using NeuronMocap.Skeleton;

namespace NeuronMocap;

/// <summary>
/// Sensor readings and bone motion of one avatar at one moment. Axis Studio sends them in place of Axis Neuron's calculation data (protocol.md section 9).
/// </summary>
/// <remarks>The bones are in the order of the BVH stream. <see cref="AvatarFrame"/> describes how long a frame is valid.</remarks>
public sealed class StudioCalculationFrame : AvatarFrame
{
    /// <summary>Number of bytes after the header in a frame of 59 bones.</summary>
    public const int FullByteCount = BoneHierarchy.BoneCount * ValuesPerBone * sizeof(float);

    // 20 numbers and the flag of a lost sensor.
    private const int ValuesPerBone = 21;

    private const int Flag = 20;

    private bool _hasSkeleton;

    /// <summary>Makes a frame that owns its memory. Use it to test code that takes frames, or to provide frames from another source.</summary>
    /// <param name="header">The header; its count is replaced by the number of bytes.</param>
    /// <param name="payload">The bytes after the header; copied.</param>
    public StudioCalculationFrame(in StudioCalculationHeader header, ReadOnlySpan<byte> payload)
    {
        byte[] packet = new byte[ProtocolConstants.HeaderSize + payload.Length];
        PacketEncoder.WriteStudioCalculation(packet, header, payload);
        Borrow(new ReceivedPacket(PacketKind.StudioCalculation, packet, Stopwatch.GetTimestamp(), origin: 0));
    }

    internal StudioCalculationFrame()
    {
    }

    /// <summary>All fields of the packet's header.</summary>
    public StudioCalculationHeader Header => StudioCalculationHeader.Read(_data.Header);

    /// <inheritdoc/>
    public override int AvatarIndex => (int)StudioCalculationHeader.ReadAvatarIndex(_data.Header);

    /// <inheritdoc/>
    public override string AvatarName => AvatarNames.GetText(StudioCalculationHeader.ReadAvatarName(_data.Header));

    /// <inheritdoc/>
    public override uint? FrameIndex => StudioCalculationHeader.ReadFrameIndex(_data.Header);

    /// <summary>All bytes after the header. Valid as long as the frame.</summary>
    public ReadOnlySpan<byte> Payload => _data.Packet[ProtocolConstants.HeaderSize..];

    /// <summary>
    /// Whether the frame contains the 59 bones in the one known layout: version 2.0, <see cref="StudioCalculationHeader.FullDataMask"/> and 4956 bytes.
    /// Otherwise only <see cref="Payload"/>, <see cref="AvatarFrame.Values"/> and the header are useful, and members that take a bone throw.
    /// </summary>
    public bool HasSkeleton => _data.WhileValid(_hasSkeleton);

    /// <summary>Gets the rotation of a bone's sensor.</summary>
    /// <param name="bone">A bone.</param>
    /// <returns>The quaternion as received; the order in the stream is x y z w.</returns>
    /// <exception cref="InvalidOperationException"><see cref="HasSkeleton"/> is false.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The bone does not exist.</exception>
    public Quaternion GetSensorRotation(Bone bone) => ReadQuaternion(bone, 0);

    /// <summary>Gets the angular velocity that a bone's sensor measures.</summary>
    /// <param name="bone">A bone.</param>
    /// <returns>
    /// The value in the sensor's own axes. The unit is not documented; it is radians per second if it equals that of
    /// <see cref="CalculationFrame.GetAngularVelocity"/>.
    /// </returns>
    /// <exception cref="InvalidOperationException"><see cref="HasSkeleton"/> is false.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The bone does not exist.</exception>
    public Vector3 GetAngularVelocity(Bone bone) => ReadVector(bone, 4);

    /// <summary>Gets the acceleration that a bone's sensor measures.</summary>
    /// <param name="bone">A bone.</param>
    /// <returns>
    /// The value in the sensor's own axes. The unit is not documented; it is multiples of gravity if it equals that of
    /// <see cref="CalculationFrame.GetAcceleration"/>.
    /// </returns>
    /// <exception cref="InvalidOperationException"><see cref="HasSkeleton"/> is false.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The bone does not exist.</exception>
    public Vector3 GetAcceleration(Bone bone) => ReadVector(bone, 7);

    /// <summary>Gets the velocity of a bone's joint in the world.</summary>
    /// <param name="bone">A bone.</param>
    /// <returns>The velocity in the axes set on the server. The unit is not documented; metres per second is likely.</returns>
    /// <exception cref="InvalidOperationException"><see cref="HasSkeleton"/> is false.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The bone does not exist.</exception>
    public Vector3 GetVelocity(Bone bone) => ReadVector(bone, 10);

    /// <summary>Gets the position of a bone's joint in the world.</summary>
    /// <param name="bone">A bone.</param>
    /// <returns>Metres, in the axes set on the server.</returns>
    /// <exception cref="InvalidOperationException"><see cref="HasSkeleton"/> is false.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The bone does not exist.</exception>
    public Vector3 GetPosition(Bone bone) => ReadVector(bone, 13);

    /// <summary>
    /// Gets the rotation of a bone; as far as is known, in the world. For the rotation of its sensor, use <see cref="GetSensorRotation"/>.
    /// </summary>
    /// <param name="bone">A bone.</param>
    /// <returns>The quaternion as received; the order in the stream is x y z w.</returns>
    /// <exception cref="InvalidOperationException"><see cref="HasSkeleton"/> is false.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The bone does not exist.</exception>
    public Quaternion GetBoneRotation(Bone bone) => ReadQuaternion(bone, 16);

    /// <summary>Determines whether the server has lost the sensor of a bone.</summary>
    /// <param name="bone">A bone.</param>
    /// <exception cref="InvalidOperationException"><see cref="HasSkeleton"/> is false.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The bone does not exist.</exception>
    public bool IsSensorLost(Bone bone) => BitConverter.SingleToInt32Bits(Read(bone, Flag, 1)[0]) != 0;

    /// <summary>Makes a copy that owns its memory and stays valid.</summary>
    /// <returns>A frame equal to this one, including its time of receipt.</returns>
    public new StudioCalculationFrame Clone()
    {
        var clone = new StudioCalculationFrame();
        clone.CopyFrom(this);
        return clone;
    }

    private protected override AvatarFrame CreateClone() => Clone();

    private protected override void OnData()
    {
        if (Payload.Length != FullByteCount)
        {
            _hasSkeleton = false;
            return;
        }

        StudioCalculationHeader header = Header;
        _hasSkeleton = header is { Version: { Major: 2, Minor: 0 }, DataMask: StudioCalculationHeader.FullDataMask };
    }

    private Vector3 ReadVector(Bone bone, int field)
    {
        ReadOnlySpan<float> values = Read(bone, field, 3);
        return new Vector3(values[0], values[1], values[2]);
    }

    private Quaternion ReadQuaternion(Bone bone, int field)
    {
        ReadOnlySpan<float> values = Read(bone, field, 4);
        return new Quaternion(values[0], values[1], values[2], values[3]);
    }

    private ReadOnlySpan<float> Read(Bone bone, int field, int count)
    {
        if ((uint)bone >= BoneHierarchy.BoneCount)
            throw new ArgumentOutOfRangeException(nameof(bone), bone, "The bone does not exist.");
        if (!HasSkeleton)
            throw new InvalidOperationException("The frame does not contain the 59 bones; see HasSkeleton.");

        return Values.Slice(((int)bone * ValuesPerBone) + field, count);
    }
}
