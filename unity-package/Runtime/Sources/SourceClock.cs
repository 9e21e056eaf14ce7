#nullable enable

using System.Diagnostics;

namespace NeuronMocap.Unity
{
    // The clock of arrivals and rendered frames of live motion: Stopwatch, which never jumps and which also stamps received frames. Unity's Time.time
    // is not suitable for live motion. It stops while the game is paused or its time scale is zero, and skips times longer than
    // Time.maximumDeltaTime. It also belongs to the main thread, so its difference from arrival times would grow with every hitch. Files follow
    // GameClock.
    internal static class SourceClock
    {
        public static long Now => Stopwatch.GetTimestamp();

        public static double ToSeconds(long timestamp) => timestamp / (double)Stopwatch.Frequency;

        public static long ToTicks(double seconds) => (long)(seconds * Stopwatch.Frequency);
    }
}
