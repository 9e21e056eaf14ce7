using NeuronMocap.Bvh;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Files;

/// <summary>Reads BVH files with progress, and so that Ctrl+C ends it.</summary>
internal static class BvhFile
{
    public static BvhDocument Load(string path, IProgress<double> progress, CancellationToken cancellationToken) =>
        BvhDocument.Load(path, new BvhReadOptions { Progress = new ReadProgress(new FileInfo(path).Length, progress, cancellationToken) });
}
