using NeuronMocap.Bvh;
using NeuronMocap.Tool.Files;

namespace NeuronMocap.Tool.Convert;

/// <summary>Copies a BVH file of any skeleton to another BVH file. Values that do not change are written as they were, digit by digit.</summary>
internal static class BvhEdit
{
    public static void Write(
        FileSettings settings, TimeRange range, string output, ConversionSummary summary, IProgress<double> progress, CancellationToken cancellationToken)
    {
        BvhDocument document = BvhFile.Load(settings.Input, progress, cancellationToken);
        summary.AddRepairs(document);
        if (settings.FrameRate is { } rate)
            document = document.Resample(rate);
        if (!range.IsAll)
        {
            (long first, long count) = range.FramesOf(document.FrameCount, document.FrameRate);
            document = document.Trim((int)first, (int)count);
        }

        if (settings.OutputOrder is { } order)
            document = document.WithRotationOrder(order);

        cancellationToken.ThrowIfCancellationRequested();
        document.Save(output);
        (summary.Frames, summary.FrameRate, summary.Seconds) = (document.FrameCount, document.FrameRate, document.FrameCount / document.FrameRate);
    }
}
