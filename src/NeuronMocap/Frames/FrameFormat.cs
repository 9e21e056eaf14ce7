using System.Buffers.Binary;
using System.Runtime.CompilerServices;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Frames;

// How to interpret the frames of one reader. The options come first, then the frame itself, then the answers of the command channel, then the defaults of
// Axis Neuron. Any thread.
internal sealed class FrameFormat(RotationOrder? order, SkeletonVariant? variant)
{
    // Version 1.1.0.1 of Axis Studio, as its four bytes are read.
    private const uint StudioVersion = 0x01010001;

    // Replaced as a whole, so that readers always see one consistent value.
    private volatile DiscoveredFormat _discovered = DiscoveredFormat.None;

    // Where the reader asks for facts that neither the options nor the frames contain.
    public string FormatOrigin { get; init; } = "the command channel";

    public RotationOrder? OptionOrder => order;

    public SkeletonVariant? OptionVariant => variant;

    public DiscoveredFormat Discovered => _discovered;

    public SkeletonVariant Variant => variant ?? _discovered.Variant ?? SkeletonFormat.Default.Variant;

    public static implicit operator FrameFormat(SkeletonFormat format) => new(format.RotationOrder, format.Variant);

    // Null keeps the known value. One thread at a time.
    public void Learn(RotationOrder? order, SkeletonVariant? variant) =>
        _discovered = _discovered with { Order = order ?? _discovered.Order, Variant = variant ?? _discovered.Variant };

    // Null if everything was answered. One thread at a time.
    public void LearnFailure(string? failure) => _discovered = _discovered with { Failure = failure };

    // The caller has checked that this is a motion header.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public SkeletonFormat Of(ReadOnlySpan<byte> header) => new(
        order ?? ReadOrder(header) ?? _discovered.Order ?? SkeletonFormat.Default.RotationOrder,
        Variant);

    // Reads the order that Axis Studio writes into the first reserved field (protocol.md section 9); null if there is no order.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static RotationOrder? ReadOrder(ReadOnlySpan<byte> header)
    {
        if (BinaryPrimitives.ReadUInt32LittleEndian(header[2..]) != StudioVersion)
            return null;

        uint order = BinaryPrimitives.ReadUInt32LittleEndian(header[50..]);
        return order <= (uint)RotationOrder.ZYX ? (RotationOrder)order : null;
    }
}
