using NeuronMocap.Bvh;

namespace NeuronMocap.Monitor.Files;

/// <summary>Reads BVH files with progress, and so that Ctrl+C ends it.</summary>
internal static class BvhFile
{
    public static BvhDocument Load(string path, IProgress<double> progress, CancellationToken cancelled)
    {
        long length = Math.Max(new FileInfo(path).Length, 1);
        return BvhDocument.Load(path, new BvhReadOptions { Progress = new Share(length, progress, cancelled) });
    }

    private sealed class Share(long length, IProgress<double> progress, CancellationToken cancelled) : IProgress<long>
    {
        public void Report(long value)
        {
            cancelled.ThrowIfCancellationRequested();
            progress.Report((double)value / length);
        }
    }
}
