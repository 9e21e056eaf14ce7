using System.Diagnostics;
using System.Numerics;
using NeuronMocap.Frames;
using NeuronMocap.Protocol;
using NeuronMocap.Skeleton;

namespace NeuronMocap;

/// <summary>The pose of one avatar at one moment, from the BVH stream (manual section 1.2.1, protocol.md section 3.1).</summary>
/// <remarks>
/// Positions are in centimetres, and angles are in degrees. The axes are right-handed: Y up, X to the subject's left, Z forward. Each transform is
/// relative to the parent bone; that of the hips is relative to the Reference node or the world. <see cref="AvatarFrame"/> describes how long a frame is
/// valid.
/// </remarks>
public sealed class MotionFrame : AvatarFrame
{
    private readonly FrameFormat _source;
    private SkeletonFormat _format;
    private ChannelLayout _layout;
    private bool _hasSkeleton;
    private int _laidOut; // The number of values that the layout is for.

    /// <summary>Creates a frame that owns its memory. Use it to test code that takes frames, or to provide frames from another source.</summary>
    /// <param name="header">The header; its count is replaced by the number of values.</param>
    /// <param name="values">The values in stream order; copied.</param>
    /// <param name="format">
    /// How to interpret the values. Null for the names of Appendix A and the rotation order in the header of an Axis Studio frame, or else YXZ.
    /// </param>
    /// <exception cref="InvalidOperationException">There are more values than the layout of the header can count.</exception>
    public MotionFrame(in MotionHeader header, ReadOnlySpan<float> values, SkeletonFormat? format = null)
        : this(format ?? new FrameFormat(order: null, variant: null))
    {
        byte[] packet = new byte[(header with { ValueCount = values.Length }).PacketSize];
        PacketEncoder.WriteMotion(packet, header, values);
        Borrow(new ReceivedPacket(PacketKind.Motion, packet, Stopwatch.GetTimestamp(), origin: 0));
    }

    internal MotionFrame(FrameFormat format) => _source = format;

    /// <summary>All fields of the packet's header, including reserved fields.</summary>
    public MotionHeader Header => MotionHeader.Read(_data.Header);

    /// <inheritdoc/>
    public override int AvatarIndex => (int)MotionHeader.ReadAvatarIndex(_data.Header);

    /// <inheritdoc/>
    public override string AvatarName => AvatarNames.GetText(MotionHeader.ReadAvatarName(_data.Header));

    /// <inheritdoc/>
    public override uint? FrameIndex => MotionHeader.ReadFrameIndex(_data.Header);

    /// <summary>How the values are interpreted.</summary>
    /// <remarks>
    /// The reader's options come first, then the frame itself (Axis Studio), then the answers of the server's command channel. The defaults are YXZ and
    /// the names of Appendix A.
    /// </remarks>
    public SkeletonFormat Format => _data.WhileValid(_format);

    /// <summary>
    /// The timecode that the server wrote into the frame; null if there is none. Only Axis Studio writes one: see <see cref="MotionHeader.Timecode"/>.
    /// </summary>
    public Timecode? Timecode => Header.Timecode;

    /// <summary>
    /// Whether the frame holds the values of the 59 bones: 180, 186, 354 or 360 values. Otherwise only <see cref="AvatarFrame.Values"/> and the header are
    /// useful, and members that take a bone throw.
    /// </summary>
    public bool HasSkeleton => _data.WhileValid(_hasSkeleton);

    /// <summary>The places of the values. The layout follows from their number, regardless of the flags in the header.</summary>
    /// <exception cref="InvalidOperationException"><see cref="HasSkeleton"/> is false.</exception>
    public ChannelLayout Layout => HasSkeleton ? _layout : throw NoSkeleton();

    /// <summary>Position and rotation of a bone relative to its parent: <see cref="GetPosition"/> and <see cref="GetRotation"/>.</summary>
    /// <param name="bone">A bone.</param>
    /// <exception cref="InvalidOperationException"><see cref="HasSkeleton"/> is false.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The bone is not defined.</exception>
    public BoneTransform this[Bone bone] => new(GetPosition(bone), GetRotation(bone));

    /// <summary>
    /// Gets the position of a bone relative to its parent. If displacement is off, the stream contains only the position of the hips. Other bones then
    /// have the positions of the default body, which are right in direction but not in length: see <see cref="DefaultOffsets"/>.
    /// </summary>
    /// <param name="bone">A bone.</param>
    /// <returns>Centimetres.</returns>
    /// <exception cref="InvalidOperationException"><see cref="HasSkeleton"/> is false.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The bone is not defined.</exception>
    public Vector3 GetPosition(Bone bone)
    {
        int index = Layout.GetPositionIndex(bone);
        return index < 0 ? DefaultOffsets.Get(bone, _format.Variant) : ReadVector(index);
    }

    /// <summary>Gets the three rotation values of a bone, as received.</summary>
    /// <param name="bone">A bone.</param>
    /// <returns>Degrees, in the order of <see cref="SkeletonFormat.RotationOrder"/>: for YXZ, component X is the angle about Y.</returns>
    /// <exception cref="InvalidOperationException"><see cref="HasSkeleton"/> is false.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The bone is not defined.</exception>
    public Vector3 GetEulerAngles(Bone bone) => ReadVector(Layout.GetRotationIndex(bone));

    /// <summary>
    /// Gets the rotation of a bone relative to its parent. Compare and interpolate these rotations, not the angles. Two frames in a row can
    /// describe nearly the same rotation with angles that differ by 180 degrees.
    /// </summary>
    /// <param name="bone">A bone.</param>
    /// <returns>A unit quaternion.</returns>
    /// <exception cref="InvalidOperationException"><see cref="HasSkeleton"/> is false.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The bone is not defined.</exception>
    public Quaternion GetRotation(Bone bone) => EulerAngles.ToQuaternion(GetEulerAngles(bone), _format.RotationOrder);

    /// <summary>
    /// Gets the Reference node, which moves and turns the whole body (manual section 1.2.1, part 4). This is the identity if the server's Reference
    /// setting is off.
    /// </summary>
    /// <returns>Centimetres and a unit quaternion, in the world.</returns>
    /// <exception cref="InvalidOperationException"><see cref="HasSkeleton"/> is false.</exception>
    public BoneTransform GetReference() => Layout.HasReference
        ? new BoneTransform(ReadVector(0), EulerAngles.ToQuaternion(ReadVector(3), _format.RotationOrder))
        : BoneTransform.Identity;

    /// <summary>Copies the transforms of all bones relative to their parents.</summary>
    /// <param name="destination">At least 59 elements, in <see cref="Bone"/> order.</param>
    /// <exception cref="InvalidOperationException"><see cref="HasSkeleton"/> is false.</exception>
    /// <exception cref="ArgumentException">The destination is too short.</exception>
    public void CopyLocalTransforms(Span<BoneTransform> destination) =>
        CopyLocalTransforms(destination, SkeletonBody.GetDefault(_format.Variant));

    /// <summary>Copies the transforms of all bones relative to their parents, for a known body.</summary>
    /// <param name="destination">At least 59 elements, in <see cref="Bone"/> order.</param>
    /// <param name="body">Provides the positions that the stream does not contain.</param>
    /// <exception cref="InvalidOperationException"><see cref="HasSkeleton"/> is false.</exception>
    /// <exception cref="ArgumentException">The destination is too short.</exception>
    public void CopyLocalTransforms(Span<BoneTransform> destination, SkeletonBody body)
    {
        ForwardKinematics.CheckRoom(destination, nameof(destination));
        PoseDecoder.Decode(Values, Layout, _format.RotationOrder, body, destination);
    }

    /// <summary>
    /// Copies the transforms of all bones in the world, including the Reference node. The default body provides positions that the stream does not
    /// contain. Allocates nothing.
    /// </summary>
    /// <param name="destination">At least 59 elements, in <see cref="Bone"/> order.</param>
    /// <exception cref="InvalidOperationException"><see cref="HasSkeleton"/> is false.</exception>
    /// <exception cref="ArgumentException">The destination is too short.</exception>
    public void CopyWorldTransforms(Span<BoneTransform> destination) =>
        CopyWorldTransforms(destination, SkeletonBody.GetDefault(_format.Variant));

    /// <summary>Copies the transforms of all bones of a known body in the world, including the Reference node. Allocates nothing.</summary>
    /// <param name="destination">At least 59 elements, in <see cref="Bone"/> order.</param>
    /// <param name="body">Provides the positions that the stream does not contain, and the bones from which the shoulders hang.</param>
    /// <exception cref="InvalidOperationException"><see cref="HasSkeleton"/> is false.</exception>
    /// <exception cref="ArgumentException">The destination is too short.</exception>
    public void CopyWorldTransforms(Span<BoneTransform> destination, SkeletonBody body)
    {
        CopyLocalTransforms(destination, body);
        ForwardKinematics.ToWorld(destination, destination, body.Variant, GetReference());
    }

    /// <summary>Creates a copy that owns its memory and stays valid.</summary>
    /// <returns>A frame equal to this one, including its time of receipt.</returns>
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
        int count = _data.ValueCount;
        if (count != _laidOut)
        {
            _hasSkeleton = ChannelLayout.TryFromValueCount(count, out _layout);
            _laidOut = count;
        }

        _format = _source.Of(_data.Header);
    }

    private static InvalidOperationException NoSkeleton() =>
        new("The frame does not contain the 59 bones; see HasSkeleton.");

    private Vector3 ReadVector(int index)
    {
        ReadOnlySpan<float> values = Values.Slice(index, 3);
        return new Vector3(values[0], values[1], values[2]);
    }
}
