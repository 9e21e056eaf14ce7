using System.Numerics;
using System.Runtime.InteropServices;
using NeuronMocap.Fuzz.Inputs;
using NeuronMocap.Protocol;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Fuzz.Targets;

/// <summary>Reads every packet of the input as a frame, and queries everything about it, for every bone.</summary>
internal sealed class FramesTarget
{
    private readonly PacketScanner _scanner = new();
    private readonly CalculationFrame _calculation = new();
    private readonly StudioCalculationFrame _studio = new();
    private readonly BoneTransform[] _bones = new BoneTransform[BoneHierarchy.BoneCount];

    private readonly MotionFrame[] _motion =
    [
        .. Enum.GetValues<RotationOrder>()
            .Zip(Enum.GetValues<SkeletonVariant>().Concat(Enum.GetValues<SkeletonVariant>()).Concat(Enum.GetValues<SkeletonVariant>()))
            .Select(pair => new MotionFrame(new SkeletonFormat(pair.First, pair.Second))),
    ];

    public void Run(FuzzInput input)
    {
        ArraySegment<byte> rest = input.Segment;
        while (_scanner.Scan(rest) is { Status: not ScanStatus.NeedMoreData } result)
        {
            if (result.Status == ScanStatus.Packet)
                Read(new ReceivedPacket(result.Kind, rest.Slice(0, result.Length), timestamp: 1, origin: 2), input);

            rest = rest.Slice(result.Length);
        }
    }

    private void Read(in ReceivedPacket packet, FuzzInput input)
    {
        input.Found++;
        if (packet.Kind == PacketKind.Motion)
        {
            MotionFrame frame = input.Random.Choose(_motion);
            frame.Borrow(packet);
            ReadShared(frame, packet, input);
            ReadMotion(frame, input);
        }
        else if (packet.Kind == PacketKind.Calculation)
        {
            _calculation.Borrow(packet);
            ReadShared(_calculation, packet, input);
            ReadCalculation(_calculation, input);
        }
        else if (packet.Kind == PacketKind.StudioCalculation)
        {
            _studio.Borrow(packet);
            ReadStudio(_studio, packet, input);
        }
        else
        {
            HeadersTarget.AddFields(ref input.Digest, DataCommandHeader.Read(packet.Bytes));
        }
    }

    private static void ReadShared(AvatarFrame frame, in ReceivedPacket packet, FuzzInput input)
    {
        WrongResultException.ThrowUnless(
            MemoryMarshal.AsBytes(frame.Values).SequenceEqual(packet.Bytes[ProtocolConstants.HeaderSize..]),
            "The {0} values are not those of the packet of {1} bytes.",
            frame.Values.Length,
            packet.Length);
        WrongResultException.ThrowUnless((frame.Timestamp, frame.Sender) == (1, 2) && frame.Age > TimeSpan.Zero, "Time or source is another's.");
        input.Digest.Add(frame.Values);
        input.Digest.Add((long)frame.AvatarIndex);
        input.Digest.Add(frame.AvatarName);
        input.Digest.Add(frame.FrameIndex ?? -1L);
    }

    private void ReadMotion(MotionFrame frame, FuzzInput input)
    {
        HeadersTarget.AddFields(ref input.Digest, frame.Header);
        WrongResultException.ThrowUnless(frame.Clone().Values.SequenceEqual(frame.Values) || HasNaN(frame.Values), "The clone has other values.");
        if (!frame.HasSkeleton)
        {
            CheckThrows(input, static frame => frame.GetPosition(Bone.Hips), frame);
            return;
        }

        input.Digest.Add(frame.Layout.HasDisplacement);
        input.Digest.Add(frame.Layout.HasReference);
        Add(ref input.Digest, frame.GetReference());
        foreach (Bone bone in BoneHierarchy.Bones)
        {
            Add(ref input.Digest, frame.GetEulerAngles(bone));
            Add(ref input.Digest, frame[bone]);
        }

        frame.CopyWorldTransforms(_bones);
        foreach (BoneTransform bone in _bones)
            Add(ref input.Digest, bone);
    }

    private static void ReadCalculation(CalculationFrame frame, FuzzInput input)
    {
        HeadersTarget.AddFields(ref input.Digest, frame.Header);
        WrongResultException.ThrowUnless(frame.Clone().Values.SequenceEqual(frame.Values) || HasNaN(frame.Values), "The clone has other values.");
        input.Digest.Add((long)frame.BoneCount);
        if (frame.BoneCount == 0)
        {
            CheckThrows(input, static frame => frame.LeftFootContact, frame);
            return;
        }

        input.Digest.Add(frame.LeftFootContact);
        input.Digest.Add(frame.RightFootContact);
        foreach (Bone bone in BoneHierarchy.Bones)
        {
            if (!frame.Contains(bone))
                continue;

            Add(ref input.Digest, frame.GetPosition(bone));
            Add(ref input.Digest, frame.GetVelocity(bone));
            Add(ref input.Digest, new BoneTransform(frame.GetAcceleration(bone), frame.GetSensorRotation(bone)));
            Add(ref input.Digest, frame.GetAngularVelocity(bone));
        }
    }

    private static void ReadStudio(StudioCalculationFrame frame, in ReceivedPacket packet, FuzzInput input)
    {
        WrongResultException.ThrowUnless(frame.Payload.SequenceEqual(packet.Bytes[ProtocolConstants.HeaderSize..]), "The payload is not the packet's.");
        WrongResultException.ThrowUnless(frame.Header.ByteCount == frame.Payload.Length, "The header counts other bytes.");
        input.Digest.Add((long)frame.AvatarIndex);
        input.Digest.Add(frame.AvatarName);
        input.Digest.Add(frame.FrameIndex ?? -1L);
        input.Digest.Add(frame.HasSkeleton);
        if (!frame.HasSkeleton)
        {
            CheckThrows(input, static frame => frame.GetPosition(Bone.Hips), frame);
            return;
        }

        foreach (Bone bone in BoneHierarchy.Bones)
        {
            Add(ref input.Digest, new BoneTransform(frame.GetPosition(bone), frame.GetBoneRotation(bone)));
            Add(ref input.Digest, new BoneTransform(frame.GetVelocity(bone), frame.GetSensorRotation(bone)));
            Add(ref input.Digest, frame.GetAcceleration(bone));
            Add(ref input.Digest, frame.GetAngularVelocity(bone));
            input.Digest.Add(frame.IsSensorLost(bone));
        }
    }

    // Exceptions are slow, so only one call in sixteen is checked.
    private static void CheckThrows<TFrame, TAnswer>(FuzzInput input, Func<TFrame, TAnswer> ask, TFrame frame)
    {
        if (input.Random.Below(16) > 0)
            return;

        try
        {
            ask(frame);
        }
        catch (InvalidOperationException)
        {
            return;
        }

        throw new WrongResultException("A frame without bones returned data of a bone.");
    }

    private static bool HasNaN(ReadOnlySpan<float> values)
    {
        foreach (float value in values)
        {
            if (float.IsNaN(value))
                return true;
        }

        return false;
    }

    private static void Add(ref Digest digest, Vector3 vector)
    {
        digest.Add(vector.X);
        digest.Add(vector.Y);
        digest.Add(vector.Z);
    }

    private static void Add(ref Digest digest, in BoneTransform bone)
    {
        Add(ref digest, bone.Position);
        digest.Add(bone.Rotation.X);
        digest.Add(bone.Rotation.Y);
        digest.Add(bone.Rotation.Z);
        digest.Add(bone.Rotation.W);
    }
}
