namespace NeuronMocap.Skeleton;

/// <summary>
/// The two namings of the bones at index 10 and 11. The stream does not say which one a server uses; the choice changes names, the parent
/// of the shoulders and the default offsets, never the order or the number of values (protocol.md section 3.1).
/// </summary>
public enum SkeletonVariant
{
    /// <summary>Since June 2018: Spine, Spine1, Spine2, Neck, Neck1, Head; the shoulders hang from Spine2 (manual, Appendices A and B).</summary>
    Neck1,

    /// <summary>Before: Spine, Spine1, Spine2, Spine3, Neck, Head; the shoulders hang from Spine3.</summary>
    Spine3,
}
