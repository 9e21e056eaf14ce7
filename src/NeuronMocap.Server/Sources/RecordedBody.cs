using System.Text;
using NeuronMocap.Bvh;
using NeuronMocap.Recording;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Server.Sources;

// The body that a recording's metadata tell.
internal static class RecordedBody
{
    // Null for the raw bytes of a stream, which have none.
    public static RecordingMetadata? ReadMetadata(string path)
    {
        Span<byte> start = stackalloc byte[8];
        using (var file = new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.ReadWrite | FileShare.Delete, bufferSize: 1))
        {
            if (!RecordingReader.IsRecording(start[..file.Read(start)]))
                return null;
        }

        using RecordingReader reader = RecordingReader.Open(path);
        return reader.Metadata;
    }

    // Null where the metadata do not tell. A stream with displacement has the lengths itself, more exactly than the twelve sizes.
    public static SkeletonBody? Find(RecordingMetadata? metadata, int avatarIndex, SkeletonVariant variant, bool hasDisplacement)
    {
        if (avatarIndex != 0 || metadata is null)
            return null;
        if (metadata[RecordingMetadata.BvhHierarchyKey] is { } hierarchy && Read(hierarchy, variant) is { } body)
            return body;

        return !hasDisplacement && metadata.BoneDimensions is { } dimensions ? SkeletonBody.FromDimensions(dimensions, variant) : null;
    }

    private static SkeletonBody? Read(string hierarchy, SkeletonVariant variant)
    {
        try
        {
            BvhDocument document = BvhDocument.Parse(Encoding.UTF8.GetBytes(hierarchy));
            return BvhSkeletonMap.TryCreate(document, out BvhSkeletonMap? map, out _) && map.Format.Variant == variant ? map.GetBody() : null;
        }
        catch (BvhFormatException)
        {
            return null;
        }
    }
}
