using System.Diagnostics;

namespace NeuronMocap.Server.Osc;

/// <summary>Writes poses as OSC messages.</summary>
internal interface IPoseEncoder
{
    /// <summary>Writes and sends a pose. Returns false, and sends nothing, if a value is not finite.</summary>
    bool TryEncode(AvatarPose pose, OscBundle bundle);
}

/// <summary>The times in messages.</summary>
internal static class PoseTime
{
    public static float Seconds(long timestamp, long start) => (float)((timestamp - start) / (double)Stopwatch.Frequency);
}
