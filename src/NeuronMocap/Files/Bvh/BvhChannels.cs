namespace NeuronMocap.Bvh;

// Defines the meaning of channel names.
internal static class BvhChannels
{
    public static readonly BvhChannel[] Positions = [BvhChannel.Xposition, BvhChannel.Yposition, BvhChannel.Zposition];

    public static bool IsPosition(this BvhChannel channel) => channel is >= BvhChannel.Xposition and <= BvhChannel.Zposition;

    public static bool IsRotation(this BvhChannel channel) => channel is >= BvhChannel.Xrotation and <= BvhChannel.Zrotation;

    /// <summary>The axis: 0 for X, 1 for Y, 2 for Z.</summary>
    public static int Axis(this BvhChannel channel) =>
        channel.IsPosition() ? channel - BvhChannel.Xposition : channel - BvhChannel.Xrotation;

    /// <summary>The rotation channels of an order, in the order of a row.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The rotation order is not defined.</exception>
    public static BvhChannel[] Rotations(RotationOrder order) => order switch
    {
        RotationOrder.XZY => [BvhChannel.Xrotation, BvhChannel.Zrotation, BvhChannel.Yrotation],
        RotationOrder.YXZ => [BvhChannel.Yrotation, BvhChannel.Xrotation, BvhChannel.Zrotation],
        RotationOrder.XYZ => [BvhChannel.Xrotation, BvhChannel.Yrotation, BvhChannel.Zrotation],
        RotationOrder.YZX => [BvhChannel.Yrotation, BvhChannel.Zrotation, BvhChannel.Xrotation],
        RotationOrder.ZXY => [BvhChannel.Zrotation, BvhChannel.Xrotation, BvhChannel.Yrotation],
        RotationOrder.ZYX => [BvhChannel.Zrotation, BvhChannel.Yrotation, BvhChannel.Xrotation],
        _ => throw new ArgumentOutOfRangeException(nameof(order), order, "The order must be one of the six rotation orders, 0 to 5."),
    };
}
