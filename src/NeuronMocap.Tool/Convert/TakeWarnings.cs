using NeuronMocap.Server;
using NeuronMocap.Tool.Files;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Convert;

/// <summary>Warnings about the take from which a file of poses was created.</summary>
internal static class TakeWarnings
{
    /// <summary>Adds the length of the new file and the defects of the old one.</summary>
    public static void Add(
        ConversionSummary summary, FileSettings settings, InputTake take, MotionSource written, CancellationToken cancellationToken)
    {
        long count = written.FrameCount!.Value;
        (summary.Frames, summary.FrameRate, summary.Seconds) = (count, written.FrameRate, count / written.FrameRate);
        AddInput(summary, settings, take);
        if (take.Motion is RecordingSource stream)
            AddStream(summary, settings, stream, take.Range, cancellationToken);
    }

    /// <summary>Adds the defects of the old file, unless it holds a stream.</summary>
    public static void AddInput(ConversionSummary summary, FileSettings settings, InputTake take)
    {
        if (take.Bvh is { } bvh)
        {
            summary.AddRepairs(bvh.Document);
            if (bvh.OtherJoints.Count > 0)
                summary.AddLoss($"{Quantity.Count(bvh.OtherJoints.Count, "other joint")} ({BvhFile.NamesOf(bvh.OtherJoints)})");
        }

        if (take.Calculation is { } rows)
            summary.AddRepairs(rows.Repairs, rows.RepairCount, rows.SkippedRowCount);
        if (take.Motion is CalculationSource skeleton)
            AddSkeleton(summary, settings, take, skeleton);
    }

    private static void AddSkeleton(ConversionSummary summary, FileSettings settings, InputTake take, CalculationSource source)
    {
        foreach (string warning in source.Skeleton.Warnings)
            summary.AddWarning(warning);

        if (take.Calculation is { DeclaredFrameRate: null } && settings.InputRate is null && FileKinds.Recognize(settings.Input) == FileKind.Calculation)
            summary.AddWarning("the export does not say its rate, and 120 Hz is assumed; set --rate if it differs");

        summary.AddLoss("what the sensors measured");
    }

    private static void AddStream(
        ConversionSummary summary, FileSettings settings, RecordingSource source, TimeRange range, CancellationToken cancellationToken)
    {
        (long first, long count) = range.FramesOf(source);
        foreach (RecordedGap gap in source.Gaps)
        {
            if (gap.Frame <= first || gap.Frame >= first + count)
                continue;

            summary.Gaps++;
            summary.MissingFrames += gap.Missing ?? 0;
            summary.InterpolatedFrames += gap.IsFilled ? gap.Missing ?? 0 : 0;
            if (!gap.IsFilled)
                summary.AddWarning(Quantity.Format($"at {gap.Time.TotalSeconds:0.000} s the take continues directly after a gap"));
        }

        if (!source.HasOwnBody)
            summary.AddWarning("the stream has no bone lengths; those of the default body are written");

        StreamWarnings.AddRest(
            summary,
            settings,
            frame => frame is MotionFrame { HasSkeleton: true } && (frame.Sender, frame.AvatarIndex) == (source.Sender, source.AvatarIndex),
            cancellationToken);
        summary.AddLoss(FileKinds.OfName(settings.Output!) == FileKind.Csv ? "times of arrival" : "times of arrival, and the avatar's name and number");
    }
}
