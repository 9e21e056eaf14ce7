using NeuronMocap.Recording;

namespace NeuronMocap.Tests.Playback;

internal static class RecordedFrames
{
    public static List<(AvatarFrame Frame, TimeSpan Time)> ReadAll(RecordedFrameReader reader)
    {
        List<(AvatarFrame, TimeSpan)> frames = [];
        while (reader.Read())
            frames.Add((Clone(reader.Frame), reader.Time));

        return frames;
    }

    private static AvatarFrame Clone(AvatarFrame frame) => frame switch
    {
        MotionFrame motion => motion.Clone(),
        CalculationFrame calculation => calculation.Clone(),
        _ => ((StudioCalculationFrame)frame).Clone(),
    };
}
