using System.Text;
using NeuronMocap.Bvh;
using NeuronMocap.Recording;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Server.Sources;

// The body that the metadata of a recording describe.
internal static class RecordedBody
{
    // Returns null for the raw bytes of a stream, which have no metadata.
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

    // Returns null if the metadata do not describe the body. A stream with displacement holds the lengths itself, more precisely than the twelve
    // sizes.
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
