using NeuronMocap.Protocol;
using NeuronMocap.Server.Sources;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Server.Broadcasting;

/// <summary>
/// What every frame of a broadcast consists of: for each avatar in turn a motion packet and, when asked for, a calculation packet.
/// All frames have the same size, so that whole packets can be counted and cut by arithmetic. Immutable; all threads share it.
/// </summary>
internal sealed class FramePlan
{
    public FramePlan(
        IReadOnlyList<MotionSource> sources,
        IReadOnlyList<AvatarName> names,
        ChannelLayout layout,
        RotationOrder order,
        DataVersion version,
        CalculationWriter? calculation,
        int calculationValueCount,
        long frameCount)
    {
        Sources = sources;
        Names = names;
        Layout = layout;
        Order = order;
        Version = version;
        Calculation = calculation;
        CalculationValueCount = calculation is null ? 0 : calculationValueCount;
        FrameCount = frameCount;
        MotionSize = ProtocolConstants.HeaderSize + (layout.ValueCount * sizeof(float));
        CalculationSize = calculation is null ? 0 : ProtocolConstants.HeaderSize + (calculationValueCount * sizeof(float));
    }

    public IReadOnlyList<MotionSource> Sources { get; }

    public IReadOnlyList<AvatarName> Names { get; }

    public ChannelLayout Layout { get; }

    public RotationOrder Order { get; }

    public DataVersion Version { get; }

    public CalculationWriter? Calculation { get; }

    // 946, or 338 for the body alone: the start of the longer form (CalculationFrame.BodyValueCount).
    public int CalculationValueCount { get; }

    // Frames from 0; long.MaxValue when the broadcast never ends.
    public long FrameCount { get; }

    public int MotionSize { get; }

    // 0 without calculation packets.
    public int CalculationSize { get; }

    public int AvatarCount => Sources.Count;

    public int PacketsPerFrame => AvatarCount * (Calculation is null ? 1 : 2);

    // Bytes of a frame of all avatars.
    public int FrameSize => AvatarCount * (MotionSize + CalculationSize);
}
