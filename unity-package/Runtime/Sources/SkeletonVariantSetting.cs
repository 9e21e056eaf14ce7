#nullable enable

namespace NeuronMocap.Unity
{
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
}
