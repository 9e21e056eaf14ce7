#nullable enable

using NeuronMocap.Skeleton;

namespace NeuronMocap.Unity
{
    internal static class FormatSettings
    {
        public static RotationOrder? ToOrder(this RotationOrderSetting setting) => setting switch
        {
            RotationOrderSetting.XYZ => RotationOrder.XYZ,
            RotationOrderSetting.XZY => RotationOrder.XZY,
            RotationOrderSetting.YXZ => RotationOrder.YXZ,
            RotationOrderSetting.YZX => RotationOrder.YZX,
            RotationOrderSetting.ZXY => RotationOrder.ZXY,
            RotationOrderSetting.ZYX => RotationOrder.ZYX,
            _ => null,
        };

        public static SkeletonVariant? ToVariant(this SkeletonVariantSetting setting) => setting switch
        {
            SkeletonVariantSetting.Neck1 => SkeletonVariant.Neck1,
            SkeletonVariantSetting.Spine3 => SkeletonVariant.Spine3,
            _ => null,
        };
    }
}
