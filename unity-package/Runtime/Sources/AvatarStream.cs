#nullable enable

using System;
using System.Threading;
using NeuronMocap.Motion;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Unity
{
    // An avatar of a connection. The receive thread decodes each frame once, and pushes it into the buffers of all sources that share the connection.
    internal sealed class AvatarStream
    {
        // Far beyond any stage, but still a value that Unity can handle.
        private const float FarthestPosition = 1e7f; // cm

        private const long NoTimecode = -1;

        private readonly object _gate = new object();
        private readonly BodyLearner _learner = new BodyLearner();
        private volatile PoseBuffer[] _buffers = Array.Empty<PoseBuffer>();
        private volatile SkeletonBody _body = SkeletonBody.GetDefault();
        private volatile string _name = string.Empty;
        private bool _hasLearnt;
        private long _arrival;
        private long _frames;
        private long _rejected;
        private long _timecode = NoTimecode;

        public AvatarStream(int sender, int avatarIndex, long timestamp)
        {
            Sender = sender;
            AvatarIndex = avatarIndex;
            _arrival = timestamp;
        }

        public int Sender { get; }

        public int AvatarIndex { get; }

        public string Name => _name;

        public SkeletonBody Body => _body;

        public ContactHistory Contacts { get; } = new ContactHistory();

        // Four numbers packed into one, so that reads are atomic.
        public Timecode? Timecode
        {
            get
            {
                long packed = Interlocked.Read(ref _timecode);
                return packed == NoTimecode
                    ? (Timecode?)null
                    : new Timecode((int)(packed >> 48), (int)(packed >> 40) & 0xFF, (int)(packed >> 32) & 0xFF, (int)packed);
            }
        }

        // In Stopwatch ticks.
        public long LastArrival => Interlocked.Read(ref _arrival);

        public long Frames => Interlocked.Read(ref _frames);

        // Frames with a value that is not a number, or is far out of range.
        public long Rejected => Interlocked.Read(ref _rejected);

        public bool IsWatched => _buffers.Length > 0;

        public void Attach(PoseBuffer buffer)
        {
            lock (_gate)
            {
                var buffers = new PoseBuffer[_buffers.Length + 1];
                _buffers.CopyTo(buffers, 0);
                buffers[_buffers.Length] = buffer;
                _buffers = buffers;
            }
        }

        public void Detach(PoseBuffer buffer)
        {
            lock (_gate)
                _buffers = Array.FindAll(_buffers, other => other != buffer);
        }

        // reported: the body from the command channel, or null. Receive thread.
        public void Take(MotionFrame frame, SkeletonBody? reported, Span<BoneTransform> pose)
        {
            SkeletonVariant variant = frame.Format.Variant;
            if (!frame.Layout.HasDisplacement)
                ChooseBody(variant, reported);

            frame.CopyLocalTransforms(pose, _body);
            if (frame.Layout.HasReference)
                pose[0] = frame.GetReference().Apply(pose[0]);

            // The name and the time still count, because the performer is present.
            string name = frame.AvatarName;
            if (!string.Equals(_name, name, StringComparison.Ordinal))
                _name = name;

            Interlocked.Exchange(ref _timecode, Pack(frame.Timecode));
            Interlocked.Exchange(ref _arrival, frame.Timestamp);
            if (!IsUsable(pose))
            {
                Interlocked.Increment(ref _rejected);
                return;
            }

            if (frame.Layout.HasDisplacement)
                LearnBody(pose, variant, reported);

            long number = Interlocked.Increment(ref _frames);
            double seconds = SourceClock.ToSeconds(frame.Timestamp);
            foreach (PoseBuffer buffer in _buffers)
                buffer.Push(pose, seconds, frame.FrameIndex, number);
        }

        // The contacts belong to the newest frame: a server sends both together. Receive thread.
        public void TakeContacts(FootContacts contacts) => Contacts.Add(Frames, contacts);

        private static long Pack(Timecode? timecode) => timecode is { } time
            ? ((long)time.Hours << 48) | ((long)time.Minutes << 40) | ((long)time.Seconds << 32) | (uint)time.Frames
            : NoTimecode;

        private static bool IsUsable(ReadOnlySpan<BoneTransform> pose)
        {
            for (int bone = 0; bone < BoneHierarchy.BoneCount; bone++)
            {
                BoneTransform transform = pose[bone];

                // Comparisons with NaN are false.
                bool isUsable = transform.Position.LengthSquared() < FarthestPosition * FarthestPosition
                    && transform.Rotation.LengthSquared() < 2;
                if (!isUsable)
                    return false;
            }

            return true;
        }

        private void ChooseBody(SkeletonVariant variant, SkeletonBody? reported)
        {
            SkeletonBody body = reported != null && reported.Variant == variant ? reported : SkeletonBody.GetDefault(variant);
            if (!ReferenceEquals(_body, body))
                _body = body;
        }

        private void LearnBody(ReadOnlySpan<BoneTransform> pose, SkeletonVariant variant, SkeletonBody? reported)
        {
            if (_learner.Observe(pose, variant, _hasLearnt ? _body : null, reported) is not { } body)
                return;

            _hasLearnt = true;
            _body = body;
        }
    }
}
