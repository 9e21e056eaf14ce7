using System.Text.Json.Nodes;
using NeuronMocap.Protocol;
using NeuronMocap.Recording;
using NeuronMocap.Timing;
using NeuronMocap.Tool.Files;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Info;

/// <summary>The frames of a stream by avatar, and the bytes that are not frames.</summary>
internal sealed class StreamContents
{
    private readonly Dictionary<(PacketKind Kind, int Source, int Avatar), Frames> _frames = [];
    private readonly SortedSet<string> _formats = new(StringComparer.Ordinal);
    private IReadOnlyList<AvatarStatistics> _avatars = [];
    private ReaderStatistics _statistics;
    private TimeSpan _duration;
    private (SkipReason Reason, long Bytes)[] _skipped = [];

    public static StreamContents Read(string path, PlaybackOptions options, IProgress<double> progress, CancellationToken cancellationToken)
    {
        var contents = new StreamContents();
        using RecordedFrameReader reader = RecordedFrameReader.Open(path, options);
        while (reader.Read())
        {
            cancellationToken.ThrowIfCancellationRequested();
            progress.Report(reader.Duration > TimeSpan.Zero ? reader.Time / reader.Duration : 0);
            contents.Take(reader.Frame, reader.Time, reader.Connection);
        }

        contents._duration = reader.Duration;
        contents._statistics = reader.GetStatistics();
        contents._avatars = reader.GetAvatarStatistics();
        contents._skipped = [.. Enum.GetValues<SkipReason>().Select(reason => (reason, reader.GetSkipped(reason))).Where(static skipped => skipped.Item2 > 0)];
        return contents;
    }

    /// <summary>Whether the selected avatar, or any, has motion frames of the 59 bones.</summary>
    public bool HasPoses(FileSettings settings) => _frames.Any(pair => pair.Value.HasSkeleton && settings.Selects(pair.Key.Source, pair.Key.Avatar));

    /// <summary>Whether an avatar has motion frames of Axis Studio, which contain their rotation order.</summary>
    public bool HasStudioMotion(int sender, int avatar) => _frames.GetValueOrDefault((PacketKind.Motion, sender, avatar)) is { HasStudioMotion: true };

    /// <summary>Whether the selected avatar, or any, has calculation frames of Axis Neuron.</summary>
    public bool HasCalculation(FileSettings settings) =>
        _frames.Keys.Any(key => key.Kind == PacketKind.Calculation && settings.Selects(key.Source, key.Avatar));

    /// <summary>The sender after the name of an avatar. Most streams have one, which is not named.</summary>
    public static string OfSender(int sender) => sender == 0 ? string.Empty : $" of sender {sender}";

    public void AddTo(InfoReport report, bool hasTimes)
    {
        InfoSection stream = report.Section("stream", "Stream");
        if (!hasTimes)
            stream.Add("seconds", "duration", Quantity.Format($"{_duration.TotalSeconds:0.000} s at the rate of its frames, because the bytes have no times"), _duration.TotalSeconds);

        stream.Add("formats", "formats", string.Join(", ", _formats), new JsonArray([.. _formats.Select(static format => (JsonNode)format)]));
        stream.Add(
            "motionFrames",
            "frames",
            Quantity.Format($"{_statistics.MotionFrames:#,0} motion, {_statistics.CalculationFrames + _statistics.StudioCalculationFrames:#,0} calculation"),
            _statistics.MotionFrames);
        stream.Add("calculationFrames", string.Empty, null, _statistics.CalculationFrames + _statistics.StudioCalculationFrames);
        stream.Add("lostFrames", "lost", $"{Quantity.Count(_statistics.Lost, "frame")}, by the frame index", _statistics.Lost);
        stream.Add("skippedBytes", "skipped", Skipped(), SkippedJson());

        InfoSection avatars = report.Section("avatars", "Avatars");
        foreach (AvatarStatistics avatar in _avatars)
            AddAvatar(avatars, avatar, hasTimes);
    }

    private void Take(AvatarFrame frame, TimeSpan time, int connection)
    {
        (PacketKind kind, string format) = frame switch
        {
            MotionFrame motion => (PacketKind.Motion, DescribeMotion(motion)),
            CalculationFrame calculation => (PacketKind.Calculation, $"calculation data of {Quantity.Count(calculation.BoneCount, "bone")}"),
            _ => (PacketKind.StudioCalculation, "calculation data of Axis Studio"),
        };
        _formats.Add(format);
        var key = (kind, frame.Sender, frame.AvatarIndex);
        if (!_frames.TryGetValue(key, out Frames? frames))
            _frames.Add(key, frames = new Frames());

        frames.Take(frame, time, connection);
    }

    private static string DescribeMotion(MotionFrame frame)
    {
        DataVersion version = frame.Header.Version;
        string header = version == DataVersion.None ? "text" : version == DataVersion.Studio ? "Axis Studio's packets" : $"packets of version {version}";
        return Quantity.Format($"motion as {header}, {frame.Values.Length} {Quantity.Noun(frame.Values.Length, "value")}");
    }

    private string Skipped() => _skipped.Length == 0
        ? "no bytes"
        : string.Join(", ", _skipped.Select(static skipped => $"{Quantity.Count(skipped.Bytes, "byte")} {Describe(skipped.Reason)}"));

    private JsonObject SkippedJson()
    {
        var json = new JsonObject();
        foreach ((SkipReason reason, long bytes) in _skipped)
            json[char.ToLowerInvariant(reason.ToString()[0]) + reason.ToString()[1..]] = bytes;

        return json;
    }

    private static string Describe(SkipReason reason) => reason switch
    {
        SkipReason.NoTokens => "that are not packets",
        SkipReason.UnknownVersion => "of an unknown version",
        SkipReason.TooLarge => "of packets that are too large",
        SkipReason.Incomplete => "of incomplete packets",
        SkipReason.MalformedLine => "of lines that are not frames",
        SkipReason.MissingAvatar => "of lines without the avatar's number and name",
        SkipReason.TooManySenders => "of more senders than 64 at a time",
        SkipReason.NotCalculation => "of motion on the port of calculation data",
        _ => "of lines with ambiguous names",
    };

    private void AddAvatar(InfoSection section, AvatarStatistics avatar, bool hasTimes)
    {
        Frames? frames = _frames.GetValueOrDefault((avatar.Kind, avatar.Sender, avatar.AvatarIndex));
        string kind = avatar.Kind == PacketKind.Motion ? "motion" : "calculation";
        string text = Quantity.Format($"{avatar.AvatarIndex} {avatar.AvatarName}{OfSender(avatar.Sender)}: {Quantity.Count(avatar.Frames, kind + " frame")}");
        if (hasTimes && frames?.FrameRate is { } rate)
            text += Quantity.Format($", {rate:0.0} Hz, at most {frames.LongestInterval.TotalMilliseconds:0} ms between two");
        if (avatar.FrequencyReduction > 1)
            text += $", 1 of {avatar.FrequencyReduction} frames sent";
        text += Quantity.Format($", {(avatar.Lost == 0 ? "none" : Quantity.Count(avatar.Lost))} lost");
        if (avatar.Gaps > 0)
            text += $" in {Quantity.Count(avatar.Gaps, "gap")}";
        if (avatar.Restarts > 0)
            text += Quantity.Format($", count restarted {(avatar.Restarts == 1 ? "once" : Quantity.Format($"{avatar.Restarts:#,0} times"))}");

        section.Item(text, new JsonObject
        {
            ["avatar"] = avatar.AvatarIndex,
            ["name"] = avatar.AvatarName,
            ["source"] = avatar.Sender,
            ["kind"] = avatar.Kind.ToString(),
            ["frames"] = avatar.Frames,
            ["rate"] = hasTimes && frames?.FrameRate is { } known ? Math.Round(known, 4) : null,
            ["longestIntervalSeconds"] = hasTimes && frames is not null ? Math.Round(frames.LongestInterval.TotalSeconds, 7) : null,
            ["lost"] = avatar.Lost,
            ["gaps"] = avatar.Gaps,
            ["outOfOrder"] = avatar.OutOfOrder,
            ["restarts"] = avatar.Restarts,
            ["frequencyReduction"] = avatar.FrequencyReduction,
        });
    }

    // The frames of one avatar and kind.
    private sealed class Frames
    {
        private readonly FrameTiming _timing = new();
        private TimeSpan? _last;

        public bool HasSkeleton { get; private set; }

        public bool HasStudioMotion { get; private set; }

        public TimeSpan LongestInterval { get; private set; }

        public double? FrameRate => _timing.MeasuredRate;

        public void Take(AvatarFrame frame, TimeSpan time, int connection)
        {
            HasSkeleton |= frame is MotionFrame { HasSkeleton: true };
            HasStudioMotion |= frame is MotionFrame { HasSkeleton: true, Header.Version: var version } && version == DataVersion.Studio;
            _timing.Add(frame.FrameIndex, time, connection);
            if (_last is { } last && time - last > LongestInterval)
                LongestInterval = time - last;

            _last = time;
        }
    }
}
