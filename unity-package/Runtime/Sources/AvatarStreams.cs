#nullable enable

using System;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Unity
{
    // The avatars of a connection, in the order of their first frame. The receive thread adds and feeds them, one frame at a time. Any thread reads
    // the list, which is replaced instead of changed.
    internal sealed class AvatarStreams
    {
        // Indices come from the network. The limit keeps invalid indices from filling the memory.
        private const int Limit = 256;

        private readonly BoneTransform[] _pose = new BoneTransform[BoneHierarchy.BoneCount];
        private volatile AvatarStream[] _all = Array.Empty<AvatarStream>();

        public AvatarStream[] All => _all;

        // The reader to ask for the sizes of avatars. Set before the first frame.
        public NeuronReader? Reader { get; set; }

        // Handler of NeuronReader.MotionReceived.
        public void OnMotion(MotionFrame frame)
        {
            if (!frame.HasSkeleton || FindOrAdd(frame) is not { } stream)
                return;

            SkeletonBody? reported = null;
            Reader?.TryGetBody(frame.AvatarIndex, out reported);
            stream.Take(frame, reported, _pose);
        }

        // Handler of NeuronReader.CalculationReceived. An avatar without motion frames cannot be shown, even if its contacts are known.
        public void OnCalculation(CalculationFrame frame)
        {
            if (frame.BoneCount > 0)
                Find(frame.Sender, frame.AvatarIndex)?.TakeContacts(frame.FootContacts);
        }

        private AvatarStream? Find(int sender, int avatarIndex)
        {
            foreach (AvatarStream stream in _all)
            {
                if (stream.AvatarIndex == avatarIndex && stream.Sender == sender)
                    return stream;
            }

            return null;
        }

        private AvatarStream? FindOrAdd(MotionFrame frame)
        {
            if (Find(frame.Sender, frame.AvatarIndex) is { } known)
                return known;

            AvatarStream[] before = _all;
            int place = before.Length < Limit ? before.Length : FindUnused(before);
            if (place < 0)
                return null;

            var added = new AvatarStream(frame.Sender, frame.AvatarIndex, frame.Timestamp);
            var all = new AvatarStream[Math.Max(before.Length, place + 1)];
            before.CopyTo(all, 0);
            all[place] = added;
            _all = all;
            return added;
        }

        // The avatar that no source uses and that has been silent the longest.
        private static int FindUnused(AvatarStream[] streams)
        {
            int found = -1;
            for (int i = 0; i < streams.Length; i++)
            {
                if (!streams[i].IsWatched && (found < 0 || streams[i].LastArrival < streams[found].LastArrival))
                    found = i;
            }

            return found;
        }
    }
}
