#nullable enable

using System.Collections.Generic;

using NeuronMocap.Bvh;
using NeuronMocap.Recording;
using NeuronMocap.Server;

namespace NeuronMocap.Unity
{
    // Creates what a connection receives from, for all kinds except the network: a player of a file, or a broadcaster without a port. Simulated data
    // takes the same path as data of a suit, but no socket. Any thread; reading a file may take long.
    internal static class SourceFeeds
    {
        public static Broadcaster CreateSimulator(SourceSettings settings)
        {
            var performers = new List<MotionSource>();
            for (int i = 0; i < settings.Performers; i++)
                performers.Add(CreatePerformer(settings, i));

            return Start(new BroadcasterOptions { Sources = performers });
        }

        // A loop has no end, so that its performer stays connected.
        public static RecordingPlayer OpenTake(SourceSettings settings, byte[]? bytes, ManualClock clock)
        {
            BvhDocument document = bytes != null ? BvhDocument.Parse(bytes) : BvhDocument.Load(settings.File);
            MotionSource take = new BvhSource(document);
            RecordingPlayer player = MotionPlayer.Create(
                settings.Loop ? new LoopedSource(take) : take, settings.Name, new PlaybackOptions { Clock = clock });
            player.Speed = settings.Speed;
            return player;
        }

        public static RecordingPlayer OpenRecording(SourceSettings settings, ManualClock clock)
        {
            RecordingPlayer player = RecordingPlayer.Open(settings.File, new PlaybackOptions { Clock = clock });
            player.Speed = settings.Speed;
            player.Passes = settings.Loop ? RecordingPlayer.Endless : 1;
            return player;
        }

        private static MotionSource CreatePerformer(SourceSettings settings, int index) => settings.Motion == SimulatedMotion.WalkAndGestures
            ? new SyntheticSource(settings.FrameRate, index)
            : (MotionSource)new StandingSource(settings.FrameRate, index, settings.Motion == SimulatedMotion.JointByJoint);

        // With displacement, so that the stream carries the performer's sizes.
        private static Broadcaster Start(BroadcasterOptions options)
        {
            options.Port = null;
            options.IncludeDisplacement = true;
            var broadcaster = new Broadcaster(options);
            try
            {
                broadcaster.Start();
                return broadcaster;
            }
            catch
            {
                broadcaster.Dispose();
                throw;
            }
        }
    }
}
