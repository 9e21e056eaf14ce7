using NeuronMocap.Recording;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Playback;

/// <summary>Players and their recordings.</summary>
internal static class Played
{
    public static RecordingPlayer Open(TemporaryFile file, PlaybackTime time)
    {
        PlaybackOptions options = PlaybackOptions.CopyChecked(null);
        return new RecordingPlayer(RecordedEventSource.Open(file.Path, options), options, time);
    }

    public static TemporaryFile TenFrames() => Frames(10, interval: 8.3);

    public static TemporaryFile Frames(int count, double interval, int perPiece = 1) => Recordings.OfTcp(
        [.. Enumerable.Range(0, (count + perPiece - 1) / perPiece)
            .Select(piece => (piece * interval, TestPackets.Motions(piece * perPiece, Math.Min(perPiece, count - (piece * perPiece)))))]);
}
