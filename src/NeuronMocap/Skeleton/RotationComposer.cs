using System.Numerics;

namespace NeuronMocap.Skeleton;

// The product of three quaternions, each about one axis, written out, because most of its 48 products are with zero.
internal readonly struct RotationComposer
{
    private readonly RotationOrder _order;

    // 1 if the axes are in cyclic order, as in X Y Z. -1 if they are in reverse order.
    private readonly float _sign;

    public RotationComposer(RotationOrder order)
    {
        (int first, int second, _) = EulerAngles.Axes(order);
        _order = order;
        _sign = (second - first + 3) % 3 == 1 ? 1 : -1;
    }

    // Takes sines and cosines of half angles, in the order in which the angles are applied.
    public Quaternion Compose(Vector3 sine, Vector3 cosine)
    {
        float w = (cosine.X * cosine.Y * cosine.Z) - (_sign * sine.X * sine.Y * sine.Z);
        float i = (sine.X * cosine.Y * cosine.Z) + (_sign * cosine.X * sine.Y * sine.Z);
        float j = (cosine.X * sine.Y * cosine.Z) - (_sign * sine.X * cosine.Y * sine.Z);
        float k = (cosine.X * cosine.Y * sine.Z) + (_sign * sine.X * sine.Y * cosine.Z);
        return _order switch
        {
            RotationOrder.XZY => new Quaternion(i, k, j, w),
            RotationOrder.YXZ => new Quaternion(j, i, k, w),
            RotationOrder.XYZ => new Quaternion(i, j, k, w),
            RotationOrder.YZX => new Quaternion(k, i, j, w),
            RotationOrder.ZXY => new Quaternion(j, k, i, w),
            _ => new Quaternion(k, j, i, w),
        };
    }
}
