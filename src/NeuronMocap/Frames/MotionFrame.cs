using System.Diagnostics;
using System.Numerics;
using NeuronMocap.Frames;
using NeuronMocap.Protocol;
using NeuronMocap.Skeleton;

namespace NeuronMocap;

/// <summary>
/// The pose of one avatar at one instant, from the BVH stream (manual section 1.2.1, protocol.md section 3.1).
/// <para>
/// Positions are centimetres, angles degrees; right-handed axes, Y up, X to the subject's left, Z forward; everything is relative to the
/// parent bone, the hips to the Reference node or the world. For how long a frame is valid, see <see cref="AvatarFrame"/>.
/// </para>
/// </summary>
public sealed class MotionFrame : AvatarFrame
{
    private readonly FrameFormat _source;
    private SkeletonFormat _format;
    private ChannelLayout _layout;
    private bool _hasSkeleton;

    /// <summary>Makes a frame that owns its memory: to test code that takes frames, or to feed one from another source.</summary>
    /// <param name="header">The header; its count is replaced by the number of values.</param>
    /// <param name="values">The values in wire order; copied.</param>
    /// <param name="format">
    /// How the values are to be understood; null for the rotation order that the header of an Axis Studio frame says, else YXZ, and Appendix A.
    /// </param>
    /// <exception cref="InvalidOperationException">There are more values than the header's layout can count.</exception>
    public MotionFrame(in MotionHeader header, ReadOnlySpan<float> values, SkeletonFormat? format = null)
        : this(format ?? new FrameFormat(order: null, variant: null))
    {
        byte[] packet = new byte[(header with { ValueCount = values.Length }).PacketSize];
        PacketEncoder.WriteMotion(packet, header, values);
        Borrow(new ReceivedPacket(PacketKind.Motion, packet, Stopwatch.GetTimestamp(), origin: 0));
    }

    internal MotionFrame(FrameFormat format) => _source = format;

    /// <summary>All fields of the packet's header, reserved ones included.</summary>
    public MotionHeader Header => MotionHeader.Read(_data.Header);

    /// <inheritdoc/>
    public override int AvatarIndex => (int)MotionHeader.ReadAvatarIndex(_data.Header);

    /// <inheritdoc/>
    public override string AvatarName => AvatarNames.GetText(MotionHeader.ReadAvatarName(_data.Header));

    /// <inheritdoc/>
    public override uint? FrameIndex => MotionHeader.ReadFrameIndex(_data.Header);

    /// <summary>
    /// How the values are understood: as the reader's options say; where they leave it open, as this frame says (Axis Studio), as the server
    /// answered on its command channel, or YXZ and Appendix A.
    /// </summary>
    public SkeletonFormat Format => _data.WhileValid(_format);

    /// <summary>The timecode that the server stamped the frame with; null where it does not (all but Axis Studio): <see cref="MotionHeader.Timecode"/>.</summary>
    public Timecode? Timecode => Header.Timecode;

    /// <summary>
    /// Whether the values are those of the 59 bones: 180, 186, 354 or 360 of them. Without, only <see cref="AvatarFrame.Values"/> and the
    /// header are of use, and the members that ask for a bone throw.
    /// </summary>
    public bool HasSkeleton => _data.WhileValid(_hasSkeleton);

    /// <summary>Where the values stand; it follows from their number, whatever the header's flags say.</summary>
    /// <exception cref="InvalidOperationException"><see cref="HasSkeleton"/> is false.</exception>
    public ChannelLayout Layout => HasSkeleton ? _layout : throw NoSkeleton();

    /// <summary>Position and rotation of a bone relative to its parent: <see cref="GetPosition"/> and <see cref="GetRotation"/>.</summary>
    /// <param name="bone">A bone.</param>
    /// <exception cref="InvalidOperationException"><see cref="HasSkeleton"/> is false.</exception>
    /// <exception cref="ArgumentOutOfRangeException">There is no such bone.</exception>
    public BoneTransform this[Bone bone] => new(GetPosition(bone), GetRotation(bone));

    /// <summary>
    /// Position of a bone relative to its parent. Where the stream does not carry it (displacement off, not the hips) it is the default
    /// body's, see <see cref="DefaultOffsets"/>: right in direction, not in length.
    /// </summary>
    /// <param name="bone">A bone.</param>
    /// <returns>Centimetres.</returns>
    /// <exception cref="InvalidOperationException"><see cref="HasSkeleton"/> is false.</exception>
    /// <exception cref="ArgumentOutOfRangeException">There is no such bone.</exception>
    public Vector3 GetPosition(Bone bone)
    {
        int index = Layout.GetPositionIndex(bone);
        return index < 0 ? DefaultOffsets.Get(bone, _format.Variant) : ReadVector(index);
    }

    /// <summary>The three rotation values of a bone as they stand in the stream.</summary>
    /// <param name="bone">A bone.</param>
    /// <returns>Degrees, in the order of <see cref="SkeletonFormat.RotationOrder"/>: for YXZ, component X is the angle about Y.</returns>
    /// <exception cref="InvalidOperationException"><see cref="HasSkeleton"/> is false.</exception>
    /// <exception cref="ArgumentOutOfRangeException">There is no such bone.</exception>
    public Vector3 GetEulerAngles(Bone bone) => ReadVector(Layout.GetRotationIndex(bone));

    /// <summary>
    /// Rotation of a bone relative to its parent. Compare and interpolate these, not the angles: neighbouring frames may describe nearly
    /// the same rotation by angles that are 180 degrees apart.
    /// </summary>
    /// <param name="bone">A bone.</param>
    /// <returns>A unit quaternion.</returns>
    /// <exception cref="InvalidOperationException"><see cref="HasSkeleton"/> is false.</exception>
    /// <exception cref="ArgumentOutOfRangeException">There is no such bone.</exception>
    public Quaternion GetRotation(Bone bone) => EulerAngles.ToQuaternion(GetEulerAngles(bone), _format.RotationOrder);

    /// <summary>
    /// The Reference node, which moves and turns the whole body (manual section 1.2.1, part 4); the identity when the server's Reference
    /// setting is off.
    /// </summary>
    /// <returns>Centimetres and a unit quaternion, in the world.</returns>
    /// <exception cref="InvalidOperationException"><see cref="HasSkeleton"/> is false.</exception>
    public BoneTransform GetReference() => Layout.HasReference
        ? new BoneTransform(ReadVector(0), EulerAngles.ToQuaternion(ReadVector(3), _format.RotationOrder))
        : BoneTransform.Identity;

    /// <summary>Writes the transforms of all bones relative to their parents.</summary>
    /// <param name="destination">Room for 59, in <see cref="Bone"/> order.</param>
    /// <exception cref="InvalidOperationException"><see cref="HasSkeleton"/> is false.</exception>
    /// <exception cref="ArgumentException">There is less room.</exception>
    public void CopyLocalTransforms(Span<BoneTransform> destination) =>
        CopyLocalTransforms(destination, SkeletonBody.GetDefault(_format.Variant));

    /// <summary>Writes the transforms of all bones relative to their parents, those of a known body.</summary>
    /// <param name="destination">Room for 59, in <see cref="Bone"/> order.</param>
    /// <param name="body">Gives the positions that the stream does not carry.</param>
    /// <exception cref="InvalidOperationException"><see cref="HasSkeleton"/> is false.</exception>
    /// <exception cref="ArgumentException">There is less room.</exception>
    public void CopyLocalTransforms(Span<BoneTransform> destination, SkeletonBody body)
    {
        ForwardKinematics.CheckRoom(destination, nameof(destination));
        PoseDecoder.Decode(Values, Layout, _format.RotationOrder, body, destination);
    }

    /// <summary>
    /// Writes where all bones are in the world, the Reference node included. Positions that the stream does not carry are the default body's.
    /// Allocates nothing.
    /// </summary>
    /// <param name="destination">Room for 59, in <see cref="Bone"/> order.</param>
    /// <exception cref="InvalidOperationException"><see cref="HasSkeleton"/> is false.</exception>
    /// <exception cref="ArgumentException">There is less room.</exception>
    public void CopyWorldTransforms(Span<BoneTransform> destination) =>
        CopyWorldTransforms(destination, SkeletonBody.GetDefault(_format.Variant));

    /// <summary>Writes where all bones of a known body are in the world, the Reference node included. Allocates nothing.</summary>
    /// <param name="destination">Room for 59, in <see cref="Bone"/> order.</param>
    /// <param name="body">Gives the positions that the stream does not carry, and says where the shoulders hang.</param>
    /// <exception cref="InvalidOperationException"><see cref="HasSkeleton"/> is false.</exception>
    /// <exception cref="ArgumentException">There is less room.</exception>
    public void CopyWorldTransforms(Span<BoneTransform> destination, SkeletonBody body)
    {
        CopyLocalTransforms(destination, body);
        ForwardKinematics.ToWorld(destination, destination, body.Variant, GetReference());
    }

    /// <summary>Makes a copy that owns its memory and stays valid.</summary>
    /// <returns>A frame equal to this one, time of receipt included.</returns>
    public new MotionFrame Clone()
    {
        var clone = new MotionFrame(_source);
        clone.CopyFrom(this);
        clone._format = _format;
        return clone;
    }

    private protected override AvatarFrame CreateClone() => Clone();

    private protected override void OnData()
    {
        _hasSkeleton = ChannelLayout.TryFromValueCount(_data.ValueCount, out _layout);
        _format = _source.Of(_data.Header);
    }

    private static InvalidOperationException NoSkeleton() =>
        new("The frame does not hold the 59 bones; see HasSkeleton.");

    private Vector3 ReadVector(int index)
    {
        ReadOnlySpan<float> values = Values.Slice(index, 3);
        return new Vector3(values[0], values[1], values[2]);
    }
}
