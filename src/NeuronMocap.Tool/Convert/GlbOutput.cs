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
    private TimeSpan _end;
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
            if (summary.Frames == 0)
                throw new NeuronException(Quantity.Format($"No frames remain: the take ends at {_end.TotalSeconds:0.###} s."));
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
        StreamStarts? starts = from is FileKind.Recording or FileKind.Raw ? StreamStarts.Read(settings, progress, cancellationToken) : null;
        if (starts is null || starts.Avatars.Count == 0)
        {
            InputTake take = InputTake.Load(settings, from, progress, cancellationToken);
            Add(glb, take.Motion, take.AvatarName, 0, new TakeClock(take.Motion, TimeSpan.Zero));
            TakeWarnings.AddInput(summary, settings, take);
            return;
        }

        foreach ((int avatar, TimeSpan start) in starts.Avatars)
        {
            RecordingSource source = RecordingSource.Load(settings.Input, avatar, settings.Playback, progress, cancellationToken);
            // Avatars of a server move at the same instants, although their frames arrive one after the other.
            var clock = new TakeClock(source, FrameTimes.Of((long)Math.Round((start - starts.First).TotalSeconds * source.FrameRate), source.FrameRate));
            Add(glb, source, source.AvatarName, avatar, clock);
            AddStreamWarnings(source);
        }

        StreamWarnings.AddRest(
            summary, settings, frame => frame is MotionFrame { HasSkeleton: true } && starts.Avatars.ContainsKey(frame.AvatarIndex), cancellationToken);
        summary.AddLoss("times of arrival");
    }

    private void Add(GlbWriter glb, MotionSource source, string name, int number, TakeClock clock)
    {
        var offsets = new Vector3[BoneHierarchy.BoneCount];
        var endSites = new Vector3[BoneHierarchy.BoneCount];
        source.GetBody(offsets, endSites);
        GlbAvatar avatar = glb.AddAvatar(name, new SkeletonBody(offsets, endSites, source.Variant), FigureColors.GetAccent(number));
        _avatars.Add(avatar);
        long count = source.FrameCount!.Value;
        TimeSpan? first = null;
        var step = FrameTimes.Of(1, source.FrameRate);
        for (long frame = 0; frame < count; frame++)
        {
            cancellationToken.ThrowIfCancellationRequested();
            progress.Report((double)frame / count);
            TimeSpan time = clock.TimeOf(frame);
            _end = time + step > _end ? time + step : _end;
            if (!range.Contains(time))
                continue;

            source.GetPose(frame, _pose);
            avatar.WriteFrame(time - range.Start, _pose);
            first ??= time;
            _length = time + step - first.Value > _length ? time + step - first.Value : _length;
        }

        summary.Frames += settings.FrameRate is null ? avatar.FrameCount : avatar.Animation.Times.Count;
        double rate = settings.FrameRate ?? source.FrameRate;
        summary.FrameRate = _avatars.Count == 1 || summary.FrameRate == rate ? rate : null;
    }

    private void AddStreamWarnings(RecordingSource source)
    {
        foreach (RecordedGap gap in source.Gaps)
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
            summary.AddWarning(Quantity.Format($"{repaired:#,0} frames have values that are not numbers; their bones keep the values before"));

        long skipped = _avatars.Sum(static avatar => avatar.SkippedFrames);
        if (skipped > 0)
            summary.AddWarning(Quantity.Format($"{skipped:#,0} frames are left out because their times do not advance in single precision"));
    }
}
