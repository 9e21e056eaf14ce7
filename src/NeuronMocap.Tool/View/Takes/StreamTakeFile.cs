using NeuronMocap.Calculation;
using NeuronMocap.Recording;
using NeuronMocap.Server.Sources;
using NeuronMocap.Skeleton;
using NeuronMocap.Tool.Terminal;
using NeuronMocap.Tool.View.Performers;

namespace NeuronMocap.Tool.View.Takes;

/// <summary>Reads recordings and raw streams. Each avatar of each sender is a performer.</summary>
/// <param name="path">The file.</param>
/// <param name="order">Rotation order of the stream; null for the order that the file states, or YXZ.</param>
/// <param name="reading">Takes the frames.</param>
internal sealed class StreamTakeFile(string path, RotationOrder? order, TakeReading reading)
{
    private const int MostPerformers = 64;

    private readonly Dictionary<PerformerKey, Avatar> _avatars = [];
    private readonly RecordingMetadata? _metadata = RecordedBody.ReadMetadata(path);
    private readonly BoneTransform[] _pose = new BoneTransform[BoneHierarchy.BoneCount];
    private bool _isFull;

    /// <summary>Reads the file.</summary>
    /// <param name="isRecording">Whether the file is a recording, which can be damaged.</param>
    public void Read(bool isRecording)
    {
        using (RecordedFrameReader reader = Open())
        {
            while (reader.Read())
            {
                Add(reader);
                reading.Report(PartOf(reader));
            }

            long skipped = reader.GetStatistics().BytesSkipped;
            if (skipped > 0)
                reading.AddProblem($"{Quantity.Bytes(skipped)} of the stream are not frames.");
        }

        if (isRecording)
            AddDamage();
        if (_avatars.Values.Any(static avatar => avatar.Writer is null))
            ReadCalculation();
    }

    private RecordedFrameReader Open() => RecordedFrameReader.Open(path, new PlaybackOptions { RotationOrder = order });

    private static double PartOf(RecordedFrameReader reader) => reader.Duration > TimeSpan.Zero ? reader.Time / reader.Duration : 0;

    private void Add(RecordedFrameReader reader)
    {
        switch (reader.Frame)
        {
            case MotionFrame { HasSkeleton: true } motion when Find(motion) is { } avatar:
                AddMotion(avatar, motion, reader);
                break;
            case CalculationFrame { BoneCount: > 0 } calculation when Find(calculation) is { } avatar:
                avatar.Contacts = calculation.FootContacts;
                if (avatar.Writer is null)
                    avatar.Sample?.Add(calculation.Values);
                break;
            default:
                break;
        }
    }

    private Avatar? Find(AvatarFrame frame)
    {
        if (_avatars.TryGetValue(PerformerKey.Of(frame), out Avatar? avatar))
            return avatar;

        if (_avatars.Count == MostPerformers)
        {
            if (!_isFull)
                reading.AddProblem($"The file has more than {MostPerformers} performers; the first {MostPerformers} are shown.");

            _isFull = true;
            return null;
        }

        avatar = new Avatar();
        _avatars.Add(PerformerKey.Of(frame), avatar);
        return avatar;
    }

    private void AddMotion(Avatar avatar, MotionFrame frame, RecordedFrameReader reader)
    {
        avatar.Writer ??= reading.Open(frame.Header.AvatarName, PerformerKey.Of(frame), FindBody(frame));
        avatar.Sample = null;
        frame.CopyLocalTransforms(_pose, avatar.Writer.Performer.Body);
        if (frame.Layout.HasReference)
            _pose[0] = frame.GetReference().Apply(_pose[0]);

        avatar.Writer.Add(reader.Time, frame.FrameIndex, reader.Connection, _pose, avatar.Contacts);
    }

    private SkeletonBody FindBody(MotionFrame frame)
    {
        SkeletonVariant variant = frame.Format.Variant;
        if (RecordedBody.Find(_metadata, frame.AvatarIndex, variant, frame.Layout.HasDisplacement) is { } known)
            return known;
        if (!frame.Layout.HasDisplacement)
            return SkeletonBody.GetDefault(variant);

        frame.CopyLocalTransforms(_pose);
        return SkeletonBody.FromPose(_pose, variant);
    }

    private void AddDamage()
    {
        using RecordingReader reader = RecordingReader.Open(path);
        long lost = 0;
        while (reader.TryRead(out RecordingEntry entry))
            lost += entry.Kind == RecordingEntryKind.BytesLost ? entry.LostBytes : 0;

        foreach (RecordingProblem problem in reader.Problems)
            reading.AddProblem(Quantity.Format($"At byte {problem.Offset:#,0}, {Quantity.Count(problem.Length, "byte")}: {problem.Description.TrimEnd('.')}."));
        if (!reader.IsComplete)
            reading.AddProblem("The recording was not closed: its last part may be missing.");
        if (lost > 0)
            reading.AddProblem($"{Quantity.Bytes(lost)} arrived that were not recorded because the disk was too slow.");
    }

    // Poses of avatars that have calculation data only.
    private void ReadCalculation()
    {
        foreach (((_, int index), Avatar avatar) in _avatars.Where(static pair => pair.Value.Writer is null))
            Measure(avatar, index);

        using RecordedFrameReader reader = Open();
        while (reader.Read())
        {
            if (reader.Frame is CalculationFrame { BoneCount: > 0 } frame
                && _avatars.TryGetValue(PerformerKey.Of(frame), out Avatar? avatar) && avatar.Skeleton is { } skeleton)
            {
                avatar.Writer ??= reading.Open(frame.Header.AvatarName, PerformerKey.Of(frame), skeleton.Body);
                skeleton.CopyLocalTransforms(frame.Values, _pose);
                avatar.Writer.Add(reader.Time, frame.FrameIndex, reader.Connection, _pose, frame.FootContacts);
            }

            reading.Report(PartOf(reader));
        }
    }

    private void Measure(Avatar avatar, int index)
    {
        try
        {
            avatar.Skeleton = avatar.Sample!.Measure();
            foreach (string warning in avatar.Skeleton.Warnings)
                reading.AddProblem(warning);
        }
        catch (CalculationFormatException exception)
        {
            reading.AddProblem($"Avatar {index}: {exception.Message}");
        }
    }

    private sealed class Avatar
    {
        public PerformerWriter? Writer { get; set; }

        public FootContacts? Contacts { get; set; }

        /// <summary>Null once the avatar has motion frames.</summary>
        public CalculationSample? Sample { get; set; } = new();

        public CalculationSkeleton? Skeleton { get; set; }
    }
}
