#nullable enable

using System;
using NeuronMocap.Recording;
using UnityEngine;

namespace NeuronMocap.Unity
{
    // The time of the game, which files follow: they pause, slow down and are captured frame by frame with the game. In edit mode there is no game, and
    // files follow the real time. Main thread.
    internal sealed class GameClock
    {
        // Frames that are due usually arrive within 0.2 ms. If the disk is slow, the game goes on and shows them later. A capture waits for them.
        private static readonly TimeSpan LongestWait = TimeSpan.FromMilliseconds(10);
        private static readonly TimeSpan LongestCaptureWait = TimeSpan.FromSeconds(10);

        private readonly double _start = Now;

        public ManualClock Clock { get; } = new ManualClock();

        private static double Now => Application.isPlaying ? Time.timeAsDouble : SourceClock.ToSeconds(SourceClock.Now);

        // Delivers the frames that are due. Returns the time of this rendered frame, in ticks of SourceClock. player: null until the file is open.
        public long Advance(RecordingPlayer? player)
        {
            Clock.MoveTo(TimeSpan.FromTicks((long)((Now - _start) * TimeSpan.TicksPerSecond)));
            player?.WaitUntilDelivered(Time.captureDeltaTime > 0 ? LongestCaptureWait : LongestWait);
            return Clock.Timestamp;
        }
    }
}
