using NeuronMocap.Recording;
using NeuronMocap.Server.Sources;
using NeuronMocap.Skeleton;
using NeuronMocap.Tool.Files;

namespace NeuronMocap.Tool.Convert;

/// <summary>What a first pass over a stream finds: its avatars, their rate and the gaps.</summary>
internal sealed class StreamSurvey
{
    // Numbers that tables give avatars whose own number belongs to an avatar of another sender.
    private const int FirstFree = 1000;

    private readonly SortedDictionary<(int Sender, int Avatar), StreamAvatar> _avatars = [];
    private readonly HashSet<int> _numbers = [];
    private RecordingMetadata? _metadata;

    /// <summary>The avatars that have poses, by their senders and numbers.</summary>
    public IReadOnlyDictionary<(int Sender, int Avatar), StreamAvatar> Avatars => _avatars;

    /// <summary>The format of the first frame.</summary>
    public SkeletonFormat Format { get; private set; }

    /// <summary>Number of frames in the range.</summary>
    public long FrameCount { get; private set; }

    public TimeSpan Duration { get; private set; }

    /// <summary>The moment at time zero. Null for raw bytes, which have no times.</summary>
    public DateTimeOffset? StartTime { get; private set; }

    /// <summary>False if a stream has neither positions nor a description of the body.</summary>
    public bool HasBoneLengths { get; private set; } = true;

    /// <summary>Frames per second of an avatar; null if the avatars differ or the times do not give a rate.</summary>
    public double? Rate => _avatars.Values.Select(static avatar => avatar.Rate).OfType<double>().Distinct().ToArray() is [var rate] ? rate : null;

    public static StreamSurvey Read(FileSettings settings, TimeRange range, IProgress<double> progress, CancellationToken cancellationToken)
    {
        var survey = new StreamSurvey { _metadata = RecordedBody.ReadMetadata(settings.Input) };
        if (survey._metadata is not null)
        {
            using RecordingReader recording = RecordingReader.Open(settings.Input);
            survey.StartTime = recording.StartTime;
        }

        using RecordedFrameReader reader = RecordedFrameReader.Open(settings.Input, settings.Playback);
        survey.Duration = reader.Duration;
        while (reader.Read())
        {
            cancellationToken.ThrowIfCancellationRequested();
            progress.Report(PartOf(reader));
            if (reader.Frame is MotionFrame frame && StreamTable.Selects(settings, frame))
                survey.Add(frame, reader, range);
        }

        return survey;
    }

    public static double PartOf(RecordedFrameReader reader) => reader.Duration > TimeSpan.Zero ? Math.Min(reader.Time / reader.Duration, 1) : 0;

    private void Add(MotionFrame frame, RecordedFrameReader reader, TimeRange range)
    {
        if (!_avatars.TryGetValue((frame.Sender, frame.AvatarIndex), out StreamAvatar? avatar))
        {
            if (_avatars.Count == 0)
                Format = frame.Format;

            SkeletonBody? own = RecordedBody.Find(_metadata, frame.AvatarIndex, frame.Format.Variant, frame.Layout.HasDisplacement);
            HasBoneLengths &= own is not null || frame.Layout.HasDisplacement;
            int number = frame.AvatarIndex;
            for (int next = FirstFree; !_numbers.Add(number); next++)
                number = next;

            string name = number == frame.AvatarIndex ? frame.AvatarName : $"{frame.AvatarName}, avatar {frame.AvatarIndex} of sender {frame.Sender}";
            avatar = new StreamAvatar(number, name, own ?? SkeletonBody.GetDefault(frame.Format.Variant));
            _avatars.Add((frame.Sender, frame.AvatarIndex), avatar);
        }

        if (!range.Contains(reader.Time))
            return;

        FrameCount++;
        avatar.Add(frame.FrameIndex, reader.Time, reader.Connection);
    }
}
