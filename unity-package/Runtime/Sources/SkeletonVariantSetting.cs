#nullable enable

namespace NeuronMocap.Unity
{
    /// <summary>The skeleton variant in the inspector: one of the two, or automatic.</summary>
    public enum SkeletonVariantSetting
    {
        /// <summary>The variant from the command channel, or else the current one, with two neck bones.</summary>
        Auto,

        /// <summary>Two spine bones above the first and two neck bones, since 2018.</summary>
        Neck1,

        /// <summary>Three spine bones above the first and one neck bone, before 2018.</summary>
        Spine3,
    }
}
