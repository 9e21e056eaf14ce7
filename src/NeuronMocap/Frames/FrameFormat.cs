using System.Buffers.Binary;
using System.Runtime.CompilerServices;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Frames;

// How the frames of one reader are to be understood: what its options say, else what the frame itself says, else what the command channel
// said, else what Axis Neuron does unless told otherwise. Any thread.
internal sealed class FrameFormat(RotationOrder? order, SkeletonVariant? variant)
{
    // Axis Studio's 1.1.0.1, as its four bytes are read.
    private const uint StudioVersion = 0x01010001;

    // Replaced as a whole, so that it is read as a whole.
    private volatile FormatFindings _findings = FormatFindings.None;

    // Who is asked for what neither the options nor the frames say.
    public string FormatOrigin { get; init; } = "the command channel";

    public RotationOrder? OptionOrder => order;

    public SkeletonVariant? OptionVariant => variant;

    public FormatFindings Findings => _findings;

    public static implicit operator FrameFormat(SkeletonFormat format) => new(format.RotationOrder, format.Variant);

    // Null leaves what is known. One thread at a time.
    public void Learn(RotationOrder? order, SkeletonVariant? variant) =>
        _findings = _findings with { Order = order ?? _findings.Order, Variant = variant ?? _findings.Variant };

    // Null when all was answered. One thread at a time.
    public void LearnFailure(string? failure) => _findings = _findings with { Failure = failure };

    // The caller has seen a motion header.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public SkeletonFormat Of(ReadOnlySpan<byte> header) => new(
        order ?? ReadOrder(header) ?? _findings.Order ?? SkeletonFormat.Default.RotationOrder,
        variant ?? _findings.Variant ?? SkeletonFormat.Default.Variant);

    // The order that Axis Studio writes into the first reserved field (protocol.md section 9); null where there is none.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static RotationOrder? ReadOrder(ReadOnlySpan<byte> header)
    {
        if (BinaryPrimitives.ReadUInt32LittleEndian(header[2..]) != StudioVersion)
            return null;

        uint order = BinaryPrimitives.ReadUInt32LittleEndian(header[50..]);
        return order <= (uint)RotationOrder.ZYX ? (RotationOrder)order : null;
    }
}
