using NeuronMocap.Bvh;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Commands;

// What a server says about an avatar's body: the skeleton of its BVH header or, where it sends none, the sizes alone.
internal sealed record BodyAnswer(BvhSkeletonMap? Skeleton, BoneDimensions Dimensions)
{
    private SkeletonBody? _body;

    // The variant counts for the sizes only; a header has its own.
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
