using System.Buffers.Binary;
using System.Numerics;
using NeuronMocap.Protocol;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Server.Osc;

/// <summary>Makes motion packets of the datagrams of a VMC sender. One thread uses it.</summary>
/// <remarks>
/// A frame ends with T or OK, whichever comes first after its bones: some senders begin a frame with them, others end it. Without both, it ends when the
/// hips come again.
/// </remarks>
internal sealed class VmcDecoder(AvatarName avatarName) : IOscListener
{
    private const int TransformSize = 7 * sizeof(float);

    private static readonly ChannelLayout Layout = new(hasDisplacement: true, hasReference: false);

    private readonly VmcSkeleton _skeleton = new();
    private readonly BoneTransform[] _pose = new BoneTransform[BoneHierarchy.BoneCount];
    private readonly float[] _values = new float[Layout.ValueCount];
    private byte[] _packets = new byte[2048];
    private int _start;
    private int _end;
    private uint _frameIndex;

    /// <summary>Number of datagrams that are not OSC, and of transforms that are not finite or have a rotation of length zero.</summary>
    public long Rejected { get; private set; }

    /// <summary>Number of bytes that wait to be read.</summary>
    public int Length => _end - _start;

    public void Receive(ReadOnlySpan<byte> datagram)
    {
        if (!OscPackets.TryRead(datagram, this))
            Rejected++;
    }

    /// <summary>Copies bytes of finished packets.</summary>
    /// <returns>The number of bytes copied.</returns>
    public int Read(Span<byte> destination)
    {
        int count = Math.Min(destination.Length, Length);
        _packets.AsSpan(_start, count).CopyTo(destination);
        _start += count;
        if (_start == _end)
            _start = _end = 0;

        return count;
    }

    void IOscListener.OnMessage(ReadOnlySpan<byte> address, ReadOnlySpan<byte> types, ReadOnlySpan<byte> arguments)
    {
        if (address.SequenceEqual("/VMC/Ext/Bone/Pos"u8))
            OnTransform(types, arguments, isRoot: false);
        else if (address.SequenceEqual("/VMC/Ext/Root/Pos"u8))
            OnTransform(types, arguments, isRoot: true);
        else if ((address.SequenceEqual("/VMC/Ext/T"u8) || address.SequenceEqual("/VMC/Ext/OK"u8)) && _skeleton.HasChanged)
            EndFrame();
    }

    // Longer forms of the message have more numbers.
    private void OnTransform(ReadOnlySpan<byte> types, ReadOnlySpan<byte> arguments, bool isRoot)
    {
        if (!types.StartsWith("sfffffff"u8)
            || !OscPackets.TryReadText(ref arguments, out ReadOnlySpan<byte> name)
            || arguments.Length < TransformSize
            || !TryReadTransform(arguments, out BoneTransform transform))
        {
            Rejected++;
            return;
        }

        if (isRoot)
        {
            _skeleton.SetRoot(transform);
            return;
        }

        if (_skeleton.HasHips && name.SequenceEqual("Hips"u8))
            EndFrame();
        _skeleton.Set(name, transform);
    }

    private static bool TryReadTransform(ReadOnlySpan<byte> bytes, out BoneTransform transform)
    {
        var position = new Vector3(Read(bytes), Read(bytes[4..]), Read(bytes[8..]));
        var rotation = new Quaternion(Read(bytes[12..]), Read(bytes[16..]), Read(bytes[20..]), Read(bytes[24..]));
        float length = rotation.Length();

        // Farther away than any stage, so that sums and products of positions stay finite.
        bool isNear = Math.Abs(position.X) < 1e6f && Math.Abs(position.Y) < 1e6f && Math.Abs(position.Z) < 1e6f;
        bool isRotation = length > 1e-3f && length < 1e6f;
        transform = new BoneTransform(position, isRotation ? rotation * (1 / length) : Quaternion.Identity);
        return isNear && isRotation;
    }

    private static float Read(ReadOnlySpan<byte> bytes) => BitConverter.Int32BitsToSingle(BinaryPrimitives.ReadInt32BigEndian(bytes));

    private void EndFrame()
    {
        _skeleton.TakePose(_pose);
        for (int bone = 0; bone < _pose.Length; bone++)
        {
            _pose[bone].Position.CopyTo(_values, 6 * bone);
            EulerAngles.FromQuaternion(_pose[bone].Rotation, RotationOrder.YXZ).CopyTo(_values, (6 * bone) + 3);
        }

        var header = new MotionHeader { HasDisplacement = true, AvatarName = avatarName, FrameIndex = _frameIndex++, ValueCount = _values.Length };
        if (_packets.Length - _end < header.PacketSize)
            Array.Resize(ref _packets, 2 * (_packets.Length + header.PacketSize));

        _end += PacketEncoder.WriteMotion(_packets.AsSpan(_end), header, _values);
    }
}
