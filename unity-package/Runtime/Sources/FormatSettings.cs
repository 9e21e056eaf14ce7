#nullable enable

using NeuronMocap.Skeleton;

namespace NeuronMocap.Unity
{
    /// <summary>The rotation order of the inspector: one of the six, or found out.</summary>
    public enum RotationOrderSetting
    {
        /// <summary>What the frames or the command channel say; else YXZ, Axis Neuron's default.</summary>
        Auto,

        /// <summary>X, then Y, then Z.</summary>
        XYZ,

        /// <summary>X, then Z, then Y.</summary>
        XZY,

        /// <summary>Y, then X, then Z: Axis Neuron's default.</summary>
        YXZ,

        /// <summary>Y, then Z, then X.</summary>
        YZX,

        /// <summary>Z, then X, then Y.</summary>
        ZXY,

        /// <summary>Z, then Y, then X.</summary>
        ZYX,
    }

    /// <summary>The skeleton variant of the inspector: one of the two, or found out.</summary>
    public enum SkeletonVariantSetting
    {
        /// <summary>What the command channel says; else the present one, with two neck bones.</summary>
        Auto,

        /// <summary>Two spine bones above the first and two neck bones: since 2018.</summary>
        Neck1,

        /// <summary>Three spine bones above the first and one neck bone: before.</summary>
        Spine3,
    }

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
