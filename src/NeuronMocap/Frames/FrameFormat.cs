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
    private volatile DiscoveredFormat _discovered = DiscoveredFormat.None;

    // Who is asked for what neither the options nor the frames say.
    public string FormatOrigin { get; init; } = "the command channel";

    public RotationOrder? OptionOrder => order;

    public SkeletonVariant? OptionVariant => variant;

    public DiscoveredFormat Discovered => _discovered;

    public SkeletonVariant Variant => variant ?? _discovered.Variant ?? SkeletonFormat.Default.Variant;

    public static implicit operator FrameFormat(SkeletonFormat format) => new(format.RotationOrder, format.Variant);

    // Null leaves what is known. One thread at a time.
    public void Learn(RotationOrder? order, SkeletonVariant? variant) =>
        _discovered = _discovered with { Order = order ?? _discovered.Order, Variant = variant ?? _discovered.Variant };

    // Null when all was answered. One thread at a time.
    public void LearnFailure(string? failure) => _discovered = _discovered with { Failure = failure };

    // The caller has seen a motion header.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public SkeletonFormat Of(ReadOnlySpan<byte> header) => new(
        order ?? ReadOrder(header) ?? _discovered.Order ?? SkeletonFormat.Default.RotationOrder,
        Variant);

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
