using NeuronMocap.Csv;
using NeuronMocap.Recording;
using NeuronMocap.Skeleton;
using NeuronMocap.Tool.Files;

namespace NeuronMocap.Tool.Convert;

/// <summary>Writes the poses of a stream as a table: a row for each frame of each avatar, as received. It keeps no poses in memory.</summary>
internal static class StreamTable
{
    /// <summary>Writes the table.</summary>
    /// <returns>False if the stream has no poses of the avatar. Nothing is written then.</returns>
    /// <exception cref="NeuronException">The range has no frame.</exception>
    public static bool TryWrite(
        FileSettings settings, TimeRange range, string path, ConversionSummary summary, IProgress<double> progress, CancellationToken cancellationToken)
    {
        var survey = StreamSurvey.Read(settings, range, progress, cancellationToken);
        if (survey.Avatars.Count == 0)
            return false;
        if (survey.FrameCount == 0)
            throw TimeRange.NoFrames(survey.Duration);

        using (var writer = new PoseCsvWriter(path, Describe(settings, range, survey)))
        {
            summary.Seconds = Copy(settings, range, survey, writer, progress, cancellationToken).TotalSeconds;
            summary.Frames = writer.RowCount;
        }

        summary.Gaps = survey.Avatars.Values.Sum(static avatar => avatar.Gaps);
        summary.MissingFrames = survey.Avatars.Values.Sum(static avatar => avatar.MissingFrames);
        if (!survey.HasBoneLengths)
            summary.AddWarning("the stream has no bone lengths; those of the default body are written");

        StreamWarnings.AddRest(summary, settings, frame => Selects(settings, frame), cancellationToken);
        return true;
    }

    /// <summary>Whether the table has a frame.</summary>
    public static bool Selects(FileSettings settings, AvatarFrame frame) =>
        frame is MotionFrame { HasSkeleton: true } && settings.Selects(frame);

    private static PoseCsvOptions Describe(FileSettings settings, TimeRange range, StreamSurvey survey) => new()
    {
        UpAxis = settings.UpAxis ?? default,
        Unit = settings.Unit ?? default,
        Variant = survey.Format.Variant,
        Source = settings.SourceName,
        RotationOrder = survey.Format.RotationOrder,
        FrameRate = survey.Rate,
        StartTime = survey.StartTime + range.Start,
        AvatarNames = survey.Avatars.Values.ToDictionary(static avatar => avatar.Number, static avatar => avatar.Name),
    };

    // Returns the time from the first frame to the last.
    private static TimeSpan Copy(
        FileSettings settings, TimeRange range, StreamSurvey survey, PoseCsvWriter writer, IProgress<double> progress, CancellationToken cancellationToken)
    {
        var pose = new BoneTransform[BoneHierarchy.BoneCount];
        (TimeSpan first, TimeSpan last) = (TimeSpan.MaxValue, TimeSpan.Zero);
        var clock = new StreamClock(survey.Avatars);
        using RecordedFrameReader reader = RecordedFrameReader.Open(settings.Input, settings.Playback);
        while (reader.Read())
        {
            cancellationToken.ThrowIfCancellationRequested();
            progress.Report(StreamSurvey.PartOf(reader));
            if (reader.Frame is not MotionFrame frame || !Selects(settings, frame) || !range.Contains(reader.Time))
                continue;

            StreamAvatar avatar = survey.Avatars[(frame.Sender, frame.AvatarIndex)];
            frame.CopyWorldTransforms(pose, avatar.Body);
            TimeSpan time = clock.TimeOf(frame, reader.Time, reader.Connection);
            (first, last) = (time < first ? time : first, time > last ? time : last);
            writer.WriteRow(time - range.Start, pose, avatar.Number, frame.FrameIndex, survey.StartTime is not null ? reader.Time - range.Start : null);
        }

        return last - first;
    }
}
