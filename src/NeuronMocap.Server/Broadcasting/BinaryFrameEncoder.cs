using System.Runtime.InteropServices;
using NeuronMocap.Protocol;

namespace NeuronMocap.Server.Broadcasting;

/// <summary>The packets of Axis Neuron.</summary>
internal class BinaryFrameEncoder : FrameEncoder
{
    // One for each avatar. Stamp writes what changes from frame to frame.
    private readonly byte[] _headers;

    public BinaryFrameEncoder(FramePlan plan)
        : base(plan)
    {
        int count = plan.HasMotion ? plan.AvatarCount : 0;
        _headers = new byte[count * ProtocolConstants.HeaderSize];
        for (int avatar = 0; avatar < count; avatar++)
            CreateHeader(avatar).Write(HeaderOf(avatar));
    }

    protected override int WriteMotion(long frame, int avatar, Span<byte> destination)
    {
        int length = Plan.MaxMotionSize;
        Span<byte> payload = destination[ProtocolConstants.HeaderSize..length];

        // The source writes into the packet where it can. A copy would cost as much as the rest of the encoding.
        if (Plan.WritesInPlace)
            Plan.Sources[avatar].WriteValues(frame, Plan.Layout, Plan.Order, MemoryMarshal.Cast<byte, float>(payload));
        else
            PacketEncoder.WriteValues(payload, GetMotion(frame, avatar));

        HeaderOf(avatar).CopyTo(destination);
        Stamp(destination, frame);
        return length;
    }

    protected virtual void Stamp(Span<byte> header, long frame) => MotionHeader.WriteFrameIndex(header, (uint)frame);

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

    private Span<byte> HeaderOf(int avatar) => _headers.AsSpan(avatar * ProtocolConstants.HeaderSize, ProtocolConstants.HeaderSize);

    private MotionHeader CreateHeader(int avatar) => new()
    {
        Version = Plan.Version,
        ValueCount = Plan.Layout.ValueCount,
        HasDisplacement = Plan.Layout.HasDisplacement,
        HasReference = Plan.Layout.HasReference,
        AvatarIndex = avatar,
        AvatarName = Plan.Names[avatar],

        // Only Axis Studio sends its rotation order here (protocol.md section 9).
        Reserved = Plan.Version == DataVersion.Studio ? (uint)Plan.Order : 0,
    };
}
