using NeuronMocap.Protocol;

namespace NeuronMocap.Server.Broadcasting;

/// <summary>The packets of Axis Neuron.</summary>
internal class BinaryFrameEncoder(FramePlan plan) : FrameEncoder(plan)
{
    protected virtual MotionHeader CreateHeader(long frame, int avatar) => new()
    {
        Version = Plan.Version,
        HasDisplacement = Plan.Layout.HasDisplacement,
        HasReference = Plan.Layout.HasReference,
        AvatarIndex = avatar,
        AvatarName = Plan.Names[avatar],
        FrameIndex = (uint)frame,

        // Only Axis Studio sends its rotation order here (protocol.md section 9).
        Reserved = Plan.Version == DataVersion.Studio ? (uint)Plan.Order : 0,
    };

    protected override int WriteMotion(long frame, int avatar, ReadOnlySpan<float> values, Span<byte> destination) =>
        PacketEncoder.WriteMotion(destination, CreateHeader(frame, avatar), values);

    protected override int WriteCalculation(long frame, int avatar, Span<byte> destination)
    {
        var header = new CalculationHeader
        {
            AvatarIndex = avatar,
            AvatarName = Plan.Names[avatar],
            FrameIndex = (uint)frame,
        };
        return PacketEncoder.WriteCalculation(destination, header, Calculate(frame, avatar));
    }
}
