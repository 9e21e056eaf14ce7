using NeuronMocap.Bvh;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Commands;

// A server's description of an avatar's body: the skeleton of its BVH header or, if it sends no header, only the sizes.
internal sealed record BodyAnswer(BvhSkeletonMap? Skeleton, BoneDimensions Dimensions)
{
    private SkeletonBody? _body;

    // The variant applies to the sizes only; a header has its own variant.
    public SkeletonBody GetBody(SkeletonVariant variant)
    {
        if (Skeleton is not null)
            return Skeleton.GetBody();

        SkeletonBody? body = Volatile.Read(ref _body);
        if (body?.Variant != variant)
            Volatile.Write(ref _body, body = SkeletonBody.FromDimensions(Dimensions, variant));

        return body;
    }
}
