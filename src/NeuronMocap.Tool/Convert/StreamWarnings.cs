using NeuronMocap.Recording;
using NeuronMocap.Tool.Files;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Convert;

/// <summary>Finds faults of a file that holds a stream, and data that a file of poses or rows cannot hold.</summary>
internal static class StreamWarnings
{
    /// <summary>Looks for damage in the container of a recording. Raw bytes have no container.</summary>
    public static void AddDamage(ConversionSummary summary, string path, CancellationToken cancellationToken)
    {
        using RecordingReader reader = RecordingReader.Open(path);
        long lost = 0;
        while (reader.TryRead(out RecordingEntry entry))
        {
            cancellationToken.ThrowIfCancellationRequested();
            if (entry.Kind == RecordingEntryKind.BytesLost)
                lost += entry.LostBytes;
        }

        foreach (RecordingProblem problem in reader.Problems)
            summary.AddWarning(Quantity.Format($"at byte {problem.Offset:#,0}, {Quantity.Count(problem.Length, "byte")}: {problem.Description}"));
        if (!reader.IsComplete)
            summary.AddWarning("the recording was not closed: its last part may be missing");
        if (lost > 0)
            summary.AddWarning($"{Quantity.Bytes(lost)} arrived that were not recorded because the disk was too slow");
    }

    /// <summary>Counts the frames of a written file, as a reader will count them.</summary>
    public static void AddStream(ConversionSummary summary, string path, bool hasTimes, CancellationToken cancellationToken)
    {
        using RecordedFrameReader? reader = TryOpen(path);
        if (reader is null)
        {
            summary.AddWarning("it has no frames");
            return;
        }

        while (reader.Read())
            cancellationToken.ThrowIfCancellationRequested();

        ReaderStatistics statistics = reader.GetStatistics();
        summary.Frames = statistics.MotionFrames + statistics.CalculationFrames + statistics.StudioCalculationFrames;
        summary.Seconds = hasTimes ? reader.Duration.TotalSeconds : null;
        summary.MissingFrames = statistics.Lost;
        summary.Gaps = statistics.Gaps;
        if (statistics.BytesSkipped > 0)
            summary.AddWarning($"{Quantity.Bytes(statistics.BytesSkipped)} are not frames");
        if (!hasTimes)
            summary.AddLoss("times, rotation order and body: raw bytes cannot hold them; give --rate and --order when reading");
    }

    /// <summary>Finds the data that a take of one avatar leaves out.</summary>
    /// <param name="summary">Receives the results.</param>
    /// <param name="settings">The input.</param>
    /// <param name="isOf">Whether a frame is kept.</param>
    /// <param name="cancellationToken">Cancels the work.</param>
    public static void AddRest(ConversionSummary summary, FileSettings settings, Func<AvatarFrame, bool> isOf, CancellationToken cancellationToken)
    {
        using RecordedFrameReader reader = RecordedFrameReader.Open(settings.Input, settings.Playback);
        (long others, bool isStudio, bool hasMotion) = (0, false, false);
        while (reader.Read())
        {
            cancellationToken.ThrowIfCancellationRequested();
            if (!isOf(reader.Frame))
            {
                others++;
                continue;
            }

            hasMotion |= reader.Frame is MotionFrame;
            isStudio |= reader.Frame is MotionFrame { Header.Version: var version } && version == DataVersion.Studio;
        }

        if (reader.GetStatistics().BytesSkipped > 0)
            summary.AddWarning($"{Quantity.Bytes(reader.GetStatistics().BytesSkipped)} are not frames");
        if (hasMotion && !isStudio && !settings.KnowsOrder())
            summary.AddWarning("the rotation order of the stream is not known, and YXZ is assumed; set --order if it differs");
        if (others > 0)
            summary.AddLoss($"{Quantity.Count(others, "frame")} of other avatars or kinds");
    }

    private static RecordedFrameReader? TryOpen(string path)
    {
        try
        {
            return RecordedFrameReader.Open(path);
        }
        catch (PlaybackException)
        {
            return null;
        }
    }
}
