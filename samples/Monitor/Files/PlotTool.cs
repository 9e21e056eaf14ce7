using NeuronMocap.Bvh;
using NeuronMocap.Monitor.Files.Plotting;
using NeuronMocap.Monitor.Terminal;
using NeuronMocap.Server.Sources;

namespace NeuronMocap.Monitor.Files;

/// <summary>--plot: draws a file.</summary>
internal sealed class PlotTool(FileSettings settings, StandardStreams streams)
{
    public void Run(CancellationToken cancelled)
    {
        using var output = new OutputFile(settings.Output!, settings.Overwrite);
        string name = Path.GetFileName(settings.Input);
        BvhDocument document = BvhDocument.Load(settings.Input);
        PointMotion motion = BvhSkeletonMap.TryCreate(document, out _, out _) ? new BodyMotion(new BvhSource(document)) : new JointMotion(document);
        using (var progress = new ProgressLine(streams, $"drawing {name}"))
        using (FileStream file = File.Create(output.TemporaryPath))
        {
            string subtitle = Quantity.Format($"BVH  ·  {motion.Duration:0.00} s  ·  {motion.FrameCount:#,0} frames at {motion.FrameRate:0.##} Hz");
            new TakePlot(motion, name, subtitle).Write(file, progress, cancelled);
        }

        output.Keep();
    }
}
