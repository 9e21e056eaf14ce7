using System.Text.Json.Nodes;
using NeuronMocap.Bvh;
using NeuronMocap.Server;
using NeuronMocap.Tool.Convert;
using NeuronMocap.Tool.Figures;
using NeuronMocap.Tool.Files;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Info;

/// <summary>The report of info about a recording or the raw bytes of a stream.</summary>
internal sealed class StreamInspection(FileSettings settings, bool isRecording, IProgress<double> progress)
{
    public InfoReport Run(CancellationToken cancellationToken)
    {
        long size = new FileInfo(settings.Input).Length;
        var report = new InfoReport(
            Path.GetFileName(settings.Input),
            isRecording ? "recording" : "raw",
            $"{(isRecording ? "Recording of a stream" : "Bytes of a stream, without times")}, {Quantity.Bytes(size)}");
        if (isRecording)
            RecordingSections.Add(report, settings.Input, size, progress, cancellationToken);

        StreamContents contents = StreamContents.Read(settings.Input, settings.Playback, progress, cancellationToken);
        contents.AddTo(report, isRecording);
        if (contents.HasPoses(settings))
            AddTake(report, contents, cancellationToken);
        else if (contents.HasCalculation(settings))
            AddMotion(report, InputTake.Load(settings, FileKind.Recording, progress, cancellationToken).Motion, hasBody: true, cancellationToken);

        return report;
    }

    private void AddTake(InfoReport report, StreamContents contents, CancellationToken cancellationToken)
    {
        RecordingSource source = RecordingSource.Load(settings.Input, settings.Avatar, settings.Sender, settings.Playback, progress, cancellationToken);
        double duration = source.FrameCount!.Value / source.FrameRate;
        InfoSection take = report.Section("take", $"Take of avatar {source.AvatarIndex}, {source.AvatarName}{StreamContents.OfSender(source.Sender)}");
        take.Add("source", string.Empty, null, source.Sender).Add("avatar", string.Empty, null, source.AvatarIndex);
        take.Add("avatarName", string.Empty, null, JsonValue.Create(source.AvatarName));
        take.Add("seconds", "duration", Quantity.Format($"{duration:0.000} s"), duration);
        take.Add("frames", "frames", Frames(source), source.FrameCount.Value);
        take.Add("receivedFrames", string.Empty, null, source.ReceivedFrames).Add("interpolatedFrames", string.Empty, null, source.InterpolatedFrames);
        take.Add("frameRate", "frame rate", DescribeFrameRate(source), source.FrameRate);
        take.Add("measuredRate", string.Empty, null, source.MeasuredFrameRate ?? double.NaN);
        take.Add("variant", "bone names", source.Variant.ToString());
        string order = source.Format.RotationOrder.ToString();
        bool isOrderKnown = contents.HasStudioMotion(source.Sender, source.AvatarIndex) || settings.KnowsOrder();
        take.Add("rotationOrder", "rotation order", isOrderKnown ? order : order + ", assumed; --order sets another one", order);
        take.Add("displacement", "displacement", source.Layout.HasDisplacement ? "on" : "off", source.Layout.HasDisplacement);
        take.Add("reference", "reference", source.Layout.HasReference ? "on" : "off", source.Layout.HasReference);

        InfoSection oddities = report.Section("oddities", "Oddities");
        foreach (RecordedGap gap in source.Gaps)
            AddGap(oddities, gap);

        BvhHierarchy hierarchy = BvhBoneHierarchy.Create(source.Format, source.Layout);
        RowScan scan = RowScan.Run(
            hierarchy.Joints, hierarchy.ChannelCount, checked((int)source.FrameCount.Value), frame => source.GetValues(frame), cancellationToken);
        RowWarnings.Add(oddities, scan, source.FrameRate, hierarchy.ChannelCount);
        if (oddities.IsEmpty)
            oddities.Remark("none", "none");
        AddMotion(report, source, source.HasOwnBody, cancellationToken);
    }

    private void AddMotion(InfoReport report, MotionSource source, bool hasBody, CancellationToken cancellationToken)
    {
        if (hasBody)
            BodySection.Add(report, source);

        var motion = new BodyMotion(source);
        MotionSection.Add(report, motion, TakeCurves.Measure(motion, progress, cancellationToken));
    }

    private static void AddGap(InfoSection section, RecordedGap gap)
    {
        string missing = gap.Missing is { } count ? Quantity.Count(count, "frame is missing", "frames are missing") : "an unknown number of frames is missing";
        section.Remark(
            gap.IsFilled ? "gap" : "cut",
            Quantity.Format($"{missing} before {gap.Time.TotalSeconds:0.000} s: {(gap.IsFilled ? "interpolated" : "the take continues directly after the gap")}"));
    }

    private static string Frames(RecordingSource source) => source.InterpolatedFrames == 0
        ? Quantity.Count(source.ReceivedFrames)
        : Quantity.Format($"{source.FrameCount:#,0}: {source.ReceivedFrames:#,0} received and {source.InterpolatedFrames:#,0} interpolated");

    private string DescribeFrameRate(RecordingSource source)
    {
        string rate = Quantity.Format($"{source.FrameRate:0.###} Hz");
        if (!isRecording)
            return rate + (settings.InputRate is null ? ": from the timecodes, or assumed; --rate sets another one" : ": as --rate says");

        return source.MeasuredFrameRate is { } measured
            ? rate + Quantity.Format($": {measured:0.00} by the times of arrival")
            : rate + ", assumed: there are no times";
    }
}
