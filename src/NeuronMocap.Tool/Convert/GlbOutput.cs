using System.Numerics;
using NeuronMocap.Figures;
using NeuronMocap.Gltf;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;
using NeuronMocap.Tool.Files;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Convert;

/// <summary>Writes the avatars of a file as a GLB file, one after the other. Only the frames of one avatar are in memory.</summary>
internal sealed class GlbOutput(
    FileSettings settings, TimeRange range, ConversionSummary summary, IProgress<double> progress, CancellationToken cancellationToken)
{
    private readonly List<GlbAvatar> _avatars = [];
    private readonly BoneTransform[] _pose = new BoneTransform[BoneHierarchy.BoneCount];
    private TakeClock? _clock;
    private TimeSpan _length;

    /// <summary>Writes the file.</summary>
    /// <exception cref="NeuronException">The input has no pose of the 59 bones in the range, or too many for a file.</exception>
    public void Write(FileKind from, string path)
    {
        if (settings.OutputOrder is not null)
            throw new NeuronException("--output-order: a GLB file holds quaternions, which have no order.");

        var glb = new GlbWriter(path, new GlbOptions
        {
            FrameRate = settings.FrameRate,
            RotationTolerance = (float)(settings.KeyError ?? 0),
            PositionTolerance = (float)(settings.KeyError ?? 0),
        });
        try
        {
            AddAvatars(from, glb);
        }
        catch
        {
            glb.Abandon();
            throw;
        }

        glb.Dispose();
        summary.Seconds = _length.TotalSeconds;
        AddWarnings();
    }

    private void AddAvatars(FileKind from, GlbWriter glb)
    {
        StreamStarts? starts = from is FileKind.Recording or FileKind.Raw ? StreamStarts.Read(settings, range, progress, cancellationToken) : null;
        if (starts is not { HasPoses: true })
        {
            InputTake take = InputTake.Load(settings, from, progress, cancellationToken);
            Add(glb, take.Motion, take.AvatarName, 0, take.GetPart(), static _ => TimeSpan.Zero);
            TakeWarnings.AddInput(summary, settings, take);
            return;
        }

        if (starts.Avatars.Count == 0)
            throw TimeRange.NoFrames(starts.Duration);

        // Avatars of one sender have the same colours in each file. Those of several senders can have equal numbers.
        bool hasOneSender = starts.Avatars.Keys.DistinctBy(static key => key.Sender).Count() == 1;
        foreach ((int sender, int avatar) in starts.Avatars.Keys)
        {
            RecordingSource source = RecordingSource.Load(settings.Input, avatar, sender, settings.Playback, progress, cancellationToken);
            // Avatars of a server move at the same instants, although their frames arrive one after the other.
            Add(glb, source, source.AvatarName, hasOneSender ? avatar : _avatars.Count, range.FramesOf(source), first =>
                FrameTimes.Of(Math.Max((long)Math.Round((source.GetTime(first) - starts.First).TotalSeconds * source.FrameRate), 0), source.FrameRate));
            AddStreamWarnings(source, range);
        }

        StreamWarnings.AddRest(
            summary, settings, frame => frame is MotionFrame { HasSkeleton: true } && starts.Avatars.ContainsKey((frame.Sender, frame.AvatarIndex)), cancellationToken);
        summary.AddLoss("times of arrival");
    }

    private void Add(GlbWriter glb, MotionSource source, string name, int number, (long First, long Count) part, Func<long, TimeSpan> startOf)
    {
        (long begin, long count) = part;
        var offsets = new Vector3[BoneHierarchy.BoneCount];
        var endSites = new Vector3[BoneHierarchy.BoneCount];
        source.GetBody(offsets, endSites);
        GlbAvatar avatar = glb.AddAvatar(name, new SkeletonBody(offsets, endSites, source.Variant), FigureColors.GetAccent(number));
        _avatars.Add(avatar);
        var clock = new TakeClock(source, begin, startOf(begin), _clock);
        _clock ??= clock;
        var step = FrameTimes.Of(1, source.FrameRate);
        for (long i = 0; i < count; i++)
        {
            cancellationToken.ThrowIfCancellationRequested();
            progress.Report((double)i / count);
            source.GetPose(begin + i, _pose);
            TimeSpan time = clock.TimeOf(begin + i);
            avatar.WriteFrame(time, _pose);
            _length = time + step > _length ? time + step : _length;
        }

        summary.Frames += settings.FrameRate is null ? avatar.FrameCount : avatar.Animation.Times.Count;
        double rate = settings.FrameRate ?? source.FrameRate;
        summary.FrameRate = _avatars.Count == 1 || summary.FrameRate == rate ? rate : null;
    }

    private void AddStreamWarnings(RecordingSource source, TimeRange part)
    {
        (long first, long count) = part.FramesOf(source);
        foreach (RecordedGap gap in source.Gaps.Where(gap => gap.Frame > first && gap.Frame < first + count))
        {
            summary.Gaps++;
            summary.MissingFrames += gap.Missing ?? 0;
            summary.InterpolatedFrames += gap.IsFilled ? gap.Missing ?? 0 : 0;
        }

        if (!source.HasOwnBody)
            summary.AddWarning("the stream has no bone lengths; those of the default body are written");
    }

    private void AddWarnings()
    {
        long repaired = _avatars.Sum(static avatar => avatar.RepairedFrames);
        if (repaired > 0)
            summary.AddWarning($"{Quantity.Count(repaired, "frame has", "frames have")} values that are not numbers; the bones keep the values before");

        long skipped = _avatars.Sum(static avatar => avatar.SkippedFrames);
        if (skipped > 0)
            summary.AddWarning(Quantity.Count(
                skipped,
                "frame is left out because its time does not advance in single precision",
                "frames are left out because their times do not advance in single precision"));
    }
}
