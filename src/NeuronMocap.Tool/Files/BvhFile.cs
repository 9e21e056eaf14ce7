using NeuronMocap.Bvh;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Files;

/// <summary>Reads BVH files with progress. Ctrl+C cancels the reading.</summary>
internal static class BvhFile
{
    public static BvhDocument Load(string path, IProgress<double> progress, CancellationToken cancellationToken) =>
        BvhDocument.Load(path, new BvhReadOptions { Progress = new ReadProgress(new FileInfo(path).Length, progress, cancellationToken) });
}
