using NeuronMocap.Recording;
using NeuronMocap.Tool.Files;

namespace NeuronMocap.Tool.Convert;

/// <summary>The avatars of a stream that have poses, and when each of them begins.</summary>
/// <param name="Avatars">The arrival of the first pose of each avatar, by its number.</param>
internal sealed record StreamStarts(SortedDictionary<int, TimeSpan> Avatars)
{
    /// <summary>The arrival of the first pose.</summary>
    public TimeSpan First => Avatars.Values.Min();

    public static StreamStarts Read(FileSettings settings, IProgress<double> progress, CancellationToken cancellationToken)
    {
        SortedDictionary<int, TimeSpan> avatars = [];
        using RecordedFrameReader reader = RecordedFrameReader.Open(settings.Input, settings.Playback);
        while (reader.Read())
        {
            cancellationToken.ThrowIfCancellationRequested();
            progress.Report(reader.Duration > TimeSpan.Zero ? Math.Min(reader.Time / reader.Duration, 1) : 0);
            if (reader.Frame is MotionFrame { HasSkeleton: true } frame && frame.AvatarIndex == (settings.Avatar ?? frame.AvatarIndex))
                avatars.TryAdd(frame.AvatarIndex, reader.Time);
        }

        return new StreamStarts(avatars);
    }
}
