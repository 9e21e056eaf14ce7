using NeuronMocap.Skeleton;

namespace NeuronMocap.Frames;

// What was found out about a server otherwise than from its stream. Null for what is not known; the failure is why nobody answered, in words.
internal sealed record DiscoveredFormat(RotationOrder? Order, SkeletonVariant? Variant, string? Failure)
{
    public static DiscoveredFormat None { get; } = new(null, null, null);
}
