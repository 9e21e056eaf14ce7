#nullable enable

using System;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Unity
{
    // The avatars of a connection, in the order in which they appeared. The receive thread adds and feeds them, one frame at a time; any thread reads
    // the list, which is never changed but replaced.
    internal sealed class AvatarStreams
    {
        // Indices come from the network: nobody shall fill the memory with avatars that are made up.
        private const int Limit = 256;

        private readonly BoneTransform[] _pose = new BoneTransform[BoneHierarchy.BoneCount];
        private volatile AvatarStream[] _all = Array.Empty<AvatarStream>();

        public AvatarStream[] All => _all;

        // Handler of NeuronReader.MotionReceived.
        public void OnMotion(MotionFrame frame)
        {
            if (frame.HasSkeleton)
                FindOrAdd(frame)?.Take(frame, _pose);
        }

        // Handler of NeuronReader.CalculationReceived. An avatar that has no motion frames cannot be shown, whatever is known of its feet.
        public void OnCalculation(CalculationFrame frame)
        {
            if (frame.BoneCount > 0)
                Find(frame.Source, frame.AvatarIndex)?.Contacts.Add(frame.Timestamp, frame.FootContacts);
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
            if (Find(frame.Source, frame.AvatarIndex) is { } known)
                return known;

            AvatarStream[] before = _all;
            int place = before.Length < Limit ? before.Length : FindUnused(before);
            if (place < 0)
                return null;

            var added = new AvatarStream(frame.Source, frame.AvatarIndex, frame.Timestamp);
            var all = new AvatarStream[Math.Max(before.Length, place + 1)];
            before.CopyTo(all, 0);
            all[place] = added;
            _all = all;
            return added;
        }

        // One that all sources have given up, and that has been silent the longest.
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
