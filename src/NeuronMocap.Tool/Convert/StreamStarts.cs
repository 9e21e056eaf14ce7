using NeuronMocap.Recording;
using NeuronMocap.Tool.Files;

namespace NeuronMocap.Tool.Convert;

/// <summary>The avatars of a stream that have poses, and when each of them begins.</summary>
/// <param name="HasPoses">Whether the stream has poses, in the range or outside.</param>
/// <param name="Avatars">The arrival of the first pose of each avatar in the range, by its sender and number.</param>
/// <param name="Duration">The time of the last frame of the stream.</param>
internal sealed record StreamStarts(bool HasPoses, SortedDictionary<(int Sender, int Avatar), TimeSpan> Avatars, TimeSpan Duration)
{
    /// <summary>The arrival of the first pose in the range.</summary>
    public TimeSpan First => Avatars.Values.Min();

    public static StreamStarts Read(FileSettings settings, TimeRange range, IProgress<double> progress, CancellationToken cancellationToken)
    {
        bool hasPoses = false;
        SortedDictionary<(int Sender, int Avatar), TimeSpan> avatars = [];
        using RecordedFrameReader reader = RecordedFrameReader.Open(settings.Input, settings.Playback);
        while (reader.Read())
        {
            cancellationToken.ThrowIfCancellationRequested();
            progress.Report(reader.Duration > TimeSpan.Zero ? Math.Min(reader.Time / reader.Duration, 1) : 0);
            if (!StreamTable.Selects(settings, reader.Frame))
                continue;

            hasPoses = true;
            if (range.Contains(reader.Time))
                avatars.TryAdd((reader.Frame.Sender, reader.Frame.AvatarIndex), reader.Time);
        }

        return new StreamStarts(hasPoses, avatars, reader.Duration);
    }
}
