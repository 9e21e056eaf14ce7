using System.Diagnostics.CodeAnalysis;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Bvh;

// Finds the row value that corresponds to each value of a motion packet.
internal sealed class BvhBoneColumns
{
    private const int ReferencePosition = 0;
    private const int ReferenceRotation = 3;

    private readonly BvhJoint[] _joints;
    private readonly BvhJoint? _reference;

    public BvhBoneColumns(BvhJoint[] joints, BvhJoint? reference)
    {
        _joints = joints;
        _reference = reference;
        Layout = new ChannelLayout(joints[(int)Bone.Spine].Channels.Any(IsPosition), hasReference: reference is not null);
        Indices = new int[Layout.ValueCount];
    }

    public ChannelLayout Layout { get; }

    public RotationOrder RotationOrder { get; private set; }

    public int[] Indices { get; }

    public bool TryRead([NotNullWhen(false)] out string? reason)
    {
        reason = null;
        foreach (Bone bone in BoneHierarchy.Bones)
        {
            BvhJoint joint = _joints[(int)bone];
            reason ??= ReadPositions(joint, Layout.GetPositionIndex(bone)) ?? ReadRotations(joint, Layout.GetRotationIndex(bone));
        }

        if (_reference is not null)
            reason ??= ReadPositions(_reference, ReferencePosition) ?? ReadRotations(_reference, ReferenceRotation);

        return reason is null;
    }

    private static bool IsPosition(BvhChannel channel) => channel is >= BvhChannel.Xposition and <= BvhChannel.Zposition;

    private static bool IsRotation(BvhChannel channel) => channel is >= BvhChannel.Xrotation and <= BvhChannel.Zrotation;

    // A packet always holds X, Y, Z, whatever the order in the file.
    private string? ReadPositions(BvhJoint joint, int index)
    {
        int count = joint.Channels.Count(IsPosition);
        if (count != (index < 0 ? 0 : 3))
            return $"Joint {joint.Name} has {count} position channels; a packet has 3 for the hips, and either 3 or none for all other bones.";

        for (int axis = 0; axis < count; axis++)
        {
            int place = PlaceOf(joint, BvhChannel.Xposition + axis);
            if (place < 0)
                return $"Joint {joint.Name} has the same position channel twice.";

            Indices[index + axis] = joint.FirstChannel + place;
        }

        return null;
    }

    private string? ReadRotations(BvhJoint joint, int index)
    {
        int[] places = [.. Enumerable.Range(0, joint.Channels.Count).Where(place => IsRotation(joint.Channels[place]))];
        if (places.Length != 3 || !TryGetOrder([.. places.Select(place => joint.Channels[place])], out RotationOrder order))
            return $"Joint {joint.Name} does not have one rotation channel for each of the three axes.";
        if (joint == _joints[(int)Bone.Hips])
            RotationOrder = order;
        if (order != RotationOrder)
            return $"The rotation order of joint {joint.Name} is {order}, but that of the hips is {RotationOrder}; a packet has one order for all joints.";

        for (int i = 0; i < 3; i++)
            Indices[index + i] = joint.FirstChannel + places[i];

        return null;
    }

    private static int PlaceOf(BvhJoint joint, BvhChannel channel)
    {
        for (int place = 0; place < joint.Channels.Count; place++)
        {
            if (joint.Channels[place] == channel)
                return place;
        }

        return -1;
    }

    private static bool TryGetOrder(ReadOnlySpan<BvhChannel> channels, out RotationOrder order)
    {
        RotationOrder? found = (channels[0], channels[1], channels[2]) switch
        {
            (BvhChannel.Xrotation, BvhChannel.Zrotation, BvhChannel.Yrotation) => RotationOrder.XZY,
            (BvhChannel.Yrotation, BvhChannel.Xrotation, BvhChannel.Zrotation) => RotationOrder.YXZ,
            (BvhChannel.Xrotation, BvhChannel.Yrotation, BvhChannel.Zrotation) => RotationOrder.XYZ,
            (BvhChannel.Yrotation, BvhChannel.Zrotation, BvhChannel.Xrotation) => RotationOrder.YZX,
            (BvhChannel.Zrotation, BvhChannel.Xrotation, BvhChannel.Yrotation) => RotationOrder.ZXY,
            (BvhChannel.Zrotation, BvhChannel.Yrotation, BvhChannel.Xrotation) => RotationOrder.ZYX,
            _ => null,
        };
        order = found ?? default;
        return found is not null;
    }
}
