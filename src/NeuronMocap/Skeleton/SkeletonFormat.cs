namespace NeuronMocap.Skeleton;

/// <summary>How a server's values are to be understood: what it is set to and an Axis Neuron frame does not say.</summary>
/// <param name="RotationOrder">Order of the three rotation values; YXZ unless the server is set otherwise.</param>
/// <param name="Variant">Naming of the spine and the neck; Appendix A's unless the server is older.</param>
public readonly record struct SkeletonFormat(RotationOrder RotationOrder, SkeletonVariant Variant)
{
    /// <summary>YXZ and Appendix A: what Axis Neuron sends unless told otherwise.</summary>
    public static SkeletonFormat Default => new(RotationOrder.YXZ, SkeletonVariant.Neck1);
}
