namespace NeuronMocap.Skeleton;

/// <summary>How to interpret a server's values: the settings of the server that an Axis Neuron frame does not carry.</summary>
/// <param name="RotationOrder">Order of the three rotation values. The default of Axis Neuron is YXZ.</param>
/// <param name="Variant">Naming of the spine and the neck. Servers use Appendix A of the manual, unless they are older.</param>
public readonly record struct SkeletonFormat(RotationOrder RotationOrder, SkeletonVariant Variant)
{
    /// <summary>Gets the format that Axis Neuron sends by default: YXZ and Appendix A.</summary>
    public static SkeletonFormat Default => new(RotationOrder.YXZ, SkeletonVariant.Neck1);
}
