using NeuronMocap.Skeleton;

namespace NeuronMocap.Bvh;

/// <summary>
/// Options of a <see cref="BvhTakeWriter"/>: values that frames do not contain. The values are copied when used; later changes have no effect.
/// </summary>
public sealed class BvhTakeOptions
{
    /// <summary>
    /// The body of the actor, which supplies the OFFSETs and End Sites. If the frames have displacement, their positions are the OFFSETs and only
    /// the End Sites come from this body. Null, the default, selects the default body, <see cref="SkeletonBody.GetDefault"/>. A body whose variant
    /// differs from that of the frames is not used.
    /// </summary>
    public SkeletonBody? Body { get; set; }

    /// <summary>
    /// Time from one frame to the next. Null, the default, measures it from the receive times of the frames. Late frames, such as a burst at the
    /// start, do not change it. A measured rate near a usual rate becomes that rate: 95.9 Hz becomes 96 Hz. The measurement is complete only at the
    /// end, so the stream must be seekable.
    /// </summary>
    public BvhFrameTime? FrameTime { get; set; }

    /// <summary>Specifies how missing frames are written. The default repeats the previous row.</summary>
    public BvhGapHandling GapHandling { get; set; }

    /// <summary>The text layout. The default is that of Axis Neuron.</summary>
    public BvhTextFormat TextFormat { get; set; } = BvhTextFormat.AxisNeuron;

    internal BvhTakeOptions Copy() => (BvhTakeOptions)MemberwiseClone();
}
