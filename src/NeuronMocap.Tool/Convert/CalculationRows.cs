using NeuronMocap.Calculation;
using NeuronMocap.Recording;
using NeuronMocap.Tool.Files;

namespace NeuronMocap.Tool.Convert;

/// <summary>
/// Converts the calculation frames of one avatar to the rows of an export, value by value. The times of the frames give the rate.
/// </summary>
internal static class CalculationRows
{
    /// <summary>Writes an export with one row for each frame.</summary>
    /// <returns>False if the stream has no calculation frames of the avatar, or only poses in the range. Nothing is written then.</returns>
    /// <exception cref="NeuronException">The range has no row.</exception>
    public static bool TryWrite(
        FileSettings settings, TimeRange range, string output, ConversionSummary summary, IProgress<double> progress, CancellationToken cancellationToken)
    {
        if (Survey(settings, range, progress, cancellationToken) is not { } found)
            return false;
        if (found.Times.Part.Count == 0 && found.HasPoses)
            return false;
        if (found.Times.Part.Count == 0)
            throw TimeRange.NoFrames(found.Times.End);

        (long gaps, long missing) = found.Times.CountGaps();
        double rate = settings.InputRate ?? found.Times.Rate ?? CalculationReadOptions.DefaultFrameRate;
        using (var writer = new CalculationFileWriter(output, found.ValueCount, CalculationTextFormat.AxisNeuron.WithFrameRate(rate)))
        {
            foreach (CalculationFrame frame in Read(settings, range, found, progress, cancellationToken))
            {
                if (frame.Values.Length == writer.ValueCount)
                    writer.WriteFrame(frame.Values);
                else
                    summary.RowsLeftOut++;
            }

            summary.Frames = writer.FrameCount;
        }

        (summary.FrameRate, summary.Seconds, summary.Gaps, summary.MissingFrames) = (rate, summary.Frames / rate, gaps, missing);
        if (missing > 0)
            summary.AddWarning("rows have no times, so frames after a gap come too early");

        summary.AddLoss("times of arrival, and the avatar's name and number");
        StreamWarnings.AddRest(
            summary, settings, frame => frame is CalculationFrame { BoneCount: > 0 } && found.Selects(frame), cancellationToken);
        return true;
    }

    /// <summary>Loads the rows of an avatar whose stream has no poses. Null if it has poses or no calculation frames.</summary>
    /// <remarks>All rows are loaded, because the motion in all of them shows the body. The result has the numbers of those in the range.</remarks>
    /// <exception cref="NeuronException">The range has no row.</exception>
    public static (CalculationDocument Document, string AvatarName, (long First, long Count) Rows)? TryLoad(
        FileSettings settings, TimeRange range, IProgress<double> progress, CancellationToken cancellationToken)
    {
        if (Survey(settings, range, progress, cancellationToken) is not { HasPoses: false } found)
            return null;
        if (found.Times.Part.Count == 0)
            throw TimeRange.NoFrames(found.Times.End);

        double rate = settings.InputRate ?? found.Times.Rate ?? CalculationReadOptions.DefaultFrameRate;
        using var text = new MemoryStream();
        using (var writer = new CalculationFileWriter(text, found.ValueCount, leaveOpen: true))
        {
            foreach (CalculationFrame frame in Read(settings, default, found, progress, cancellationToken))
            {
                if (frame.Values.Length == writer.ValueCount)
                    writer.WriteFrame(frame.Values);
            }
        }

        var document = CalculationDocument.Parse(text.GetBuffer().AsSpan(0, (int)text.Length), new CalculationReadOptions { FrameRate = rate });
        return (document, found.AvatarName, found.Times.Part);
    }

    // Finds the avatar, the width of its rows and their arrival times. Unless an avatar is named, the first avatar with such frames is used.
    private static Found? Survey(FileSettings settings, TimeRange range, IProgress<double> progress, CancellationToken cancellationToken)
    {
        Found? found = null;
        bool hasPoses = false;
        using RecordedFrameReader reader = RecordedFrameReader.Open(settings.Input, settings.Playback);
        while (reader.Read())
        {
            cancellationToken.ThrowIfCancellationRequested();
            progress.Report(PartOf(reader));
            hasPoses |= StreamTable.Selects(settings, reader.Frame);
            if (reader.Frame is not CalculationFrame { BoneCount: > 0 } frame || !(found?.Selects(frame) ?? settings.Selects(frame)))
                continue;
            found ??= new Found(frame.Sender, frame.AvatarIndex, frame.AvatarName, frame.Values.Length, new RowTimes());
            if (frame.Values.Length == found.ValueCount)
                found.Times.Add(frame.FrameIndex, reader.Time, reader.Connection, range.Contains(reader.Time));
        }

        return found is null ? null : found with { HasPoses = hasPoses };
    }

    // Each frame is valid until the next one.
    private static IEnumerable<CalculationFrame> Read(
        FileSettings settings, TimeRange range, Found avatar, IProgress<double> progress, CancellationToken cancellationToken)
    {
        using RecordedFrameReader reader = RecordedFrameReader.Open(settings.Input, settings.Playback);
        while (reader.Read())
        {
            cancellationToken.ThrowIfCancellationRequested();
            progress.Report(PartOf(reader));
            if (reader.Frame is CalculationFrame { BoneCount: > 0 } frame && avatar.Selects(frame) && range.Contains(reader.Time))
                yield return frame;
        }
    }

    private static double PartOf(RecordedFrameReader reader) => reader.Duration > TimeSpan.Zero ? reader.Time / reader.Duration : 0;

    private sealed record Found(int Sender, int Avatar, string AvatarName, int ValueCount, RowTimes Times)
    {
        public bool HasPoses { get; init; }

        public bool Selects(AvatarFrame frame) => (frame.Sender, frame.AvatarIndex) == (Sender, Avatar);
    }
}
