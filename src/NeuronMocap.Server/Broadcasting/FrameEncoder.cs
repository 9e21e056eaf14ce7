using NeuronMocap.Frames;
using NeuronMocap.Protocol;

namespace NeuronMocap.Server.Broadcasting;

/// <summary>
/// Writes the packets of a frame. The same frame number gives the same bytes, whoever asks. Allocates nothing per frame; because of its
/// scratch memory every thread has one of its own.
/// </summary>
internal sealed class FrameEncoder(FramePlan plan)
{
    private readonly float[] _motion = new float[plan.Layout.ValueCount];
    private readonly float[] _calculation = new float[plan.Calculation is null ? 0 : CalculationFrame.FullValueCount];

    public void Encode(long frame, Span<byte> destination)
    {
        for (int avatar = 0; avatar < plan.AvatarCount; avatar++)
        {
            WriteMotion(frame, avatar, destination);
            destination = destination[plan.MotionSize..];
            if (plan.Calculation is null)
                continue;

            WriteCalculation(frame, avatar, destination);
            destination = destination[plan.CalculationSize..];
        }
    }

    private void WriteMotion(long frame, int avatar, Span<byte> destination)
    {
        plan.Sources[avatar].WriteValues(frame, plan.Layout, plan.Order, _motion);
        var header = new MotionHeader
        {
            Version = plan.Version,
            HasDisplacement = plan.Layout.HasDisplacement,
            HasReference = plan.Layout.HasReference,
            AvatarIndex = (uint)avatar,
            AvatarName = plan.Names[avatar],
            FrameIndex = (uint)frame,

            // Axis Studio, and only it, says here which rotation order it is set to (protocol.md section 9).
            Reserved = plan.Version == DataVersion.Studio ? (uint)plan.Order : 0,
        };
        PacketEncoder.WriteMotion(destination, header, _motion);
    }

    private void WriteCalculation(long frame, int avatar, Span<byte> destination)
    {
        plan.Calculation!(plan.Sources[avatar], frame, _calculation);
        var header = new CalculationHeader
        {
            AvatarIndex = (uint)avatar,
            AvatarName = plan.Names[avatar],
            FrameIndex = (uint)frame,
        };
        PacketEncoder.WriteCalculation(destination, header, _calculation.AsSpan(0, plan.CalculationValueCount));
    }
}
