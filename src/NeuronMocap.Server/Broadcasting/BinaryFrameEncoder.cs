using System.Runtime.InteropServices;
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

    protected override int WriteMotion(long frame, int avatar, Span<byte> destination)
    {
        if (!Plan.WritesInPlace)
            return PacketEncoder.WriteMotion(destination, CreateHeader(frame, avatar), GetMotion(frame, avatar));

        // The source writes into the packet. A copy would cost as much as the rest of the encoding.
        int length = Plan.MaxMotionSize;
        Span<float> values = MemoryMarshal.Cast<byte, float>(destination[ProtocolConstants.HeaderSize..length]);
        Plan.Sources[avatar].WriteValues(frame, Plan.Layout, Plan.Order, values);
        (CreateHeader(frame, avatar) with { ValueCount = values.Length }).Write(destination);
        return length;
    }

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
