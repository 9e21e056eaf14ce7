#nullable enable

using System.Diagnostics;

namespace NeuronMocap.Unity
{
    // The clock of arrivals and of rendered frames: Stopwatch, which never jumps, and which stamps the frames as they are received. Unity's Time.time is
    // none for this: it stands still while the game is paused or its time scale is zero, leaves out what is longer than Time.maximumDeltaTime, and is
    // the main thread's own, so that the difference between it and the arrivals would grow with every hitch.
    internal static class SourceClock
    {
        public static long Now => Stopwatch.GetTimestamp();

        public static double ToSeconds(long timestamp) => timestamp / (double)Stopwatch.Frequency;

        public static long ToTicks(double seconds) => (long)(seconds * Stopwatch.Frequency);
    }
}
