using NeuronMocap.Skeleton;

namespace NeuronMocap.Frames;

// Facts about a server that its stream does not contain. Unknown facts are null. Failure says in words why the server gave no answer.
internal sealed record DiscoveredFormat(RotationOrder? Order, SkeletonVariant? Variant, string? Failure)
{
    public static DiscoveredFormat None { get; } = new(null, null, null);
}
