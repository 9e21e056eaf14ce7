using System.Buffers.Binary;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Frames;

// How the frames of one reader are to be understood: what its options say, else what the frame itself says, else what the command channel
// said, else what Axis Neuron does unless told otherwise. Any thread.
internal sealed class FrameFormat(RotationOrder? order, SkeletonVariant? variant)
{
    // Axis Studio's 1.1.0.1, as its four bytes are read.
    private const uint StudioVersion = 0x01010001;

    // Each stands alone, so that each is whole.
    private volatile int _learntOrder = -1;
    private volatile int _learntVariant = -1;

    private volatile string? _discoveryFailure;

    public RotationOrder? OptionOrder => order;

    public RotationOrder? LearntOrder => _learntOrder < 0 ? null : (RotationOrder)_learntOrder;

    public SkeletonVariant? OptionVariant => variant;

    public SkeletonVariant? LearntVariant => _learntVariant < 0 ? null : (SkeletonVariant)_learntVariant;

    // Why the command channel did not tell, in words; null while nobody asked, and when it did.
    public string? DiscoveryFailure
    {
        get => _discoveryFailure;
        set => _discoveryFailure = value;
    }

    public static implicit operator FrameFormat(SkeletonFormat format) => new(format.RotationOrder, format.Variant);

    // What was found out otherwise than from the stream; null leaves what is known.
    public void Learn(RotationOrder? order, SkeletonVariant? variant)
    {
        if (order is { } knownOrder)
            _learntOrder = (int)knownOrder;
        if (variant is { } knownVariant)
            _learntVariant = (int)knownVariant;
    }

    // The caller has seen a motion header.
    public SkeletonFormat Of(ReadOnlySpan<byte> header) => new(
        order ?? ReadOrder(header) ?? LearntOrder ?? SkeletonFormat.Default.RotationOrder,
        variant ?? LearntVariant ?? SkeletonFormat.Default.Variant);

    // The order that Axis Studio writes into the first reserved field (protocol.md section 9); null where there is none.
    public static RotationOrder? ReadOrder(ReadOnlySpan<byte> header)
    {
        if (BinaryPrimitives.ReadUInt32LittleEndian(header[2..]) != StudioVersion)
            return null;

        uint order = BinaryPrimitives.ReadUInt32LittleEndian(header[50..]);
        return order <= (uint)RotationOrder.ZYX ? (RotationOrder)order : null;
    }
}
