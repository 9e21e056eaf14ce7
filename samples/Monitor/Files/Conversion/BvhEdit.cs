using NeuronMocap.Bvh;

namespace NeuronMocap.Monitor.Files.Conversion;

/// <summary>From a BVH file to another one, of any skeleton: what is not to change is written as it was.</summary>
internal static class BvhEdit
{
    public static void Write(FileSettings settings, TimeRange range, string output, CancellationToken cancelled)
    {
        BvhDocument document = BvhDocument.Load(settings.Input);
        cancelled.ThrowIfCancellationRequested();
        document.Save(output);
    }
}
