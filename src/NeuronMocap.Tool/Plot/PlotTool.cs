using NeuronMocap.Bvh;
using NeuronMocap.Tool.Convert;
using NeuronMocap.Tool.Figures;
using NeuronMocap.Tool.Files;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Plot;

/// <summary>Draws a plot of a file.</summary>
internal sealed class PlotTool(FileSettings settings, StandardStreams streams)
{
    private BvhDocument? _document;

    /// <summary>Draws the plot. Returns the exit code.</summary>
    public Task<int> RunAsync(CancellationToken cancellationToken) => new FileRun(settings, streams).RunAsync((output, stop) => Run(output!, stop), cancellationToken);

    private void Run(OutputFile output, CancellationToken cancellationToken)
    {
        FileKind kind = settings.RecognizeInput();
        output.Write(path => Draw(kind, path, cancellationToken));
        Report();
    }

    private void Draw(FileKind kind, string path, CancellationToken cancellationToken)
    {
        string name = Path.GetFileName(settings.Input);
        using var progress = new ProgressLine(streams, $"drawing {name}");
        (PointMotion motion, string subtitle) = Load(kind, progress, cancellationToken);
        using FileStream file = File.Create(path);
        new TakePlot(motion, name, subtitle).Write(file, progress, cancellationToken);
    }

    private (PointMotion Motion, string Subtitle) Load(FileKind kind, IProgress<double> progress, CancellationToken cancellationToken)
    {
        var range = new TimeRange(settings.From, settings.To);
        if (kind == FileKind.Bvh)
        {
            BvhDocument document = BvhFile.Load(settings.Input, progress, cancellationToken);
            _document = document;
            if (document.FrameCount == 0)
                throw new NeuronException("The file holds a skeleton but no frames.");
            if (!range.IsAll)
            {
                (long first, long count) = range.FramesOf(document.FrameCount, document.FrameRate);
                document = document.Trim((int)first, (int)count);
            }

            PointMotion motion = BvhSkeletonMap.TryCreate(document, out _, out _)
                ? new BodyMotion(InputTake.Of(document).Motion)
                : new JointMotion(document);
            return (motion, Describe("BVH", motion));
        }

        InputTake take = InputTake.Load(settings, kind, progress, cancellationToken);
        var body = new BodyMotion(take.Range.IsAll ? take.Motion : new TakePart(take.Motion, take.GetPart(), rate: null));
        string what = kind switch
        {
            FileKind.Calculation => "calculation export",
            FileKind.Recording => $"recording of {take.AvatarName}",
            _ => $"stream of {take.AvatarName}",
        };
        return (body, Describe(what, body));
    }

    // A file without some of its rows is drawn all the same. A failure is reported alone, in one line.
    private void Report()
    {
        if (_document is not { SkippedRowCount: > 0 } document)
            return;

        var summary = new ConversionSummary { Frames = document.FrameCount, FrameRate = document.FrameRate, Seconds = document.FrameCount / document.FrameRate };
        summary.AddRepairs(document);
        streams.Complain(summary.Describe(Path.GetFileName(settings.Input)));
    }

    private static string Describe(string what, PointMotion motion) =>
        what + Quantity.Format($"  ·  {motion.Duration:0.00} s  ·  {Quantity.Count(motion.FrameCount, "frame")} at {motion.FrameRate:0.##} Hz");
}
