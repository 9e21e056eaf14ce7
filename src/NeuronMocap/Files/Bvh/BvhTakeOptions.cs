using NeuronMocap.Skeleton;

namespace NeuronMocap.Bvh;

/// <summary>What a <see cref="BvhTakeWriter"/> has to know and the frames do not say. Copied when used; later changes have no effect.</summary>
public sealed class BvhTakeOptions
{
    /// <summary>
    /// The actor's body, for the OFFSETs and End Sites. Where the frames have displacement their own positions are the OFFSETs, and only the End Sites are
    /// taken from here. Null, the default: the default body, <see cref="SkeletonBody.GetDefault"/>. One of the other variant than the frames' is not used.
    /// </summary>
    public SkeletonBody? Body { get; set; }

    /// <summary>
    /// Time from one frame to the next; null, the default, to measure it by the frames' times of receipt. Where that is near a usual rate, as 95.9 Hz is to 96,
    /// the usual rate is meant. It is known at the end only, so the stream has to be able to seek.
    /// </summary>
    public BvhFrameTime? FrameTime { get; set; }

    /// <summary>What becomes of missing frames; they are repeated unless set.</summary>
    public BvhGapHandling GapHandling { get; set; }

    /// <summary>How the text is laid out; as in Axis Neuron's files unless set.</summary>
    public BvhTextFormat TextFormat { get; set; } = BvhTextFormat.AxisNeuron;

    internal BvhTakeOptions Copy() => (BvhTakeOptions)MemberwiseClone();
}
