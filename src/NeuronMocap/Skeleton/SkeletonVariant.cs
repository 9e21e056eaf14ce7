namespace NeuronMocap.Skeleton;

/// <summary>
/// The two namings of the bones at index 10 and 11 (protocol.md section 3.1).
/// </summary>
/// <remarks>
/// The stream does not say which naming a server uses. The choice changes names, the parent of the shoulders and the default offsets. It never
/// changes the order or the number of values.
/// </remarks>
public enum SkeletonVariant
{
    /// <summary>
    /// Since June 2018: Spine, Spine1, Spine2, Neck, Neck1, Head. The parent of the shoulders is Spine2 (manual, Appendices A and B).
    /// </summary>
    Neck1,

    /// <summary>Before June 2018: Spine, Spine1, Spine2, Spine3, Neck, Head. The parent of the shoulders is Spine3.</summary>
    Spine3,
}
