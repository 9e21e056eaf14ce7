#nullable enable

using System;
using NeuronMocap.Motion;
using NeuronMocap.Skeleton;
using Quaternion = UnityEngine.Quaternion;
using Vector3 = UnityEngine.Vector3;

namespace NeuronMocap.Unity
{
    /// <summary>
    /// One performer of a <see cref="MocapSource"/>: the pose of this rendered frame, and who it is. Made by the source and kept up to date by it, once in
    /// each Update before other scripts run. Main thread only.
    /// </summary>
    public sealed class Performer
    {
        // How old a calculation frame may be and still tell about the feet.
        private const double OldestContacts = 0.3;

        // Later than any frame: the buffer then gives the newest one.
        private const double BeyondAll = 3600;

        private readonly AvatarStream _stream;
        private readonly FootContactEstimator _estimator = new FootContactEstimator();
        private readonly BoneTransform[] _local = new BoneTransform[BoneHierarchy.BoneCount];
        private readonly BoneTransform[] _world = new BoneTransform[BoneHierarchy.BoneCount];
        private PoseBuffer _buffer;
        private SamplingSettings _sampling;
        private long _framesShown;

        internal Performer(AvatarStream stream, in SamplingSettings sampling)
        {
            _stream = stream;
            _sampling = sampling;
            _buffer = sampling.CreateBuffer();
            Body = stream.Body;
            Name = stream.Name;
            Body.CopyRestPose(_local);
            ForwardKinematics.ToWorld(_local, _world, Body.Variant);
            _stream.Attach(_buffer);
        }

        /// <summary>Number of the performer on the server, from 0.</summary>
        public int AvatarIndex => _stream.AvatarIndex;

        /// <summary>Name of the performer on the server, as of the newest frame.</summary>
        public string Name { get; private set; }

        /// <summary>Which sender the frames come from: over UDP, 0 for the first computer that sent; otherwise always 0.</summary>
        public int Sender => _stream.Sender;

        /// <summary>
        /// The timecode of the newest frame; null where the server sends none. Only Axis Studio does. How the sub-frame relates to a frame rate is not known.
        /// </summary>
        public Timecode? Timecode => _stream.Timecode;

        /// <summary>Whether frames arrive: the newest one is younger than the source's idle timeout.</summary>
        public bool IsLive { get; private set; }

        /// <summary>How long ago the newest frame arrived, in seconds.</summary>
        public float SecondsSinceFrame { get; private set; }

        /// <summary>Frames per second, in the mean of the last few; 0 while none arrive.</summary>
        public double FrameRate => IsLive && _buffer.FrameInterval > 0 ? 1 / _buffer.FrameInterval : 0;

        /// <summary>Frames that were left out because a value was no number, or farther away than 100 km.</summary>
        public long RejectedFrames => _stream.Rejected;

        /// <summary>The sizes of the performer: learnt from the stream or the command channel; else the default ones.</summary>
        public SkeletonBody Body { get; private set; }

        /// <summary>Counts up whenever <see cref="Body"/> becomes another.</summary>
        public int BodyVersion { get; private set; }

        /// <summary>How spine and neck are divided.</summary>
        public SkeletonVariant Variant => Body.Variant;

        /// <summary>Whether there is a pose: from the first frame on.</summary>
        public bool HasPose { get; private set; }

        /// <summary>
        /// The pose of this rendered frame: 59 transforms relative to their parents in <see cref="Bone"/> order, in the stream's axes and centimetres, the
        /// hips in the world. Valid until the next rendered frame. At rest before <see cref="HasPose"/>.
        /// </summary>
        public ReadOnlySpan<BoneTransform> LocalPose => _local;

        /// <summary>As <see cref="LocalPose"/>, each bone in the world of the stream.</summary>
        public ReadOnlySpan<BoneTransform> WorldPose => _world;

        /// <summary>How the pose was made: between frames, ahead of them, or standing.</summary>
        public PoseOrigin PoseOrigin { get; private set; }

        /// <summary>Which feet stand on the ground in this pose: measured where the server sends calculation data, else estimated.</summary>
        public FootContacts Contacts { get; private set; }

        /// <summary>Whether <see cref="Contacts"/> is what the server measured.</summary>
        public bool HasMeasuredContacts { get; private set; }

        /// <summary>Where a joint is, in Unity's axes, relative to the origin of the mocap stage.</summary>
        /// <param name="bone">A bone.</param>
        /// <returns>Metres.</returns>
        /// <exception cref="ArgumentOutOfRangeException">There is no such bone.</exception>
        public Vector3 GetPosition(Bone bone) => _world[CheckedIndex(bone)].Position.ToUnityPosition();

        /// <summary>How a bone is turned, in Unity's axes, relative to the T-pose facing +Z.</summary>
        /// <param name="bone">A bone.</param>
        /// <returns>The rotation on the mocap stage; the identity in the T-pose.</returns>
        /// <exception cref="ArgumentOutOfRangeException">There is no such bone.</exception>
        public Quaternion GetRotation(Bone bone) => _world[CheckedIndex(bone)].Rotation.ToUnityRotation();

        /// <summary>Where a bone ends that has no children, such as the top of the head or the tip of a foot; of others, the joint itself.</summary>
        /// <param name="bone">A bone.</param>
        /// <returns>Metres, as <see cref="GetPosition"/>.</returns>
        /// <exception cref="ArgumentOutOfRangeException">There is no such bone.</exception>
        public Vector3 GetEndPosition(Bone bone)
        {
            int index = CheckedIndex(bone);
            return _world[index].TransformPoint(Body.EndSites[index]).ToUnityPosition();
        }

        /// <summary>Name and number.</summary>
        /// <returns>A line for a list.</returns>
        public override string ToString() => $"{Name} ({AvatarIndex})";

        internal AvatarStream Stream => _stream;

        // Of this rendered frame, in seconds of SourceClock.
        internal double Time { get; private set; }

        // now: ticks of SourceClock.
        internal void Update(long now, double idleTimeout, in SamplingSettings sampling)
        {
            if (!_sampling.Equals(sampling))
                Resample(sampling);

            Time = SourceClock.ToSeconds(now);
            SecondsSinceFrame = (float)Math.Max(0, Time - SourceClock.ToSeconds(_stream.LastArrival));
            IsLive = SecondsSinceFrame < idleTimeout;
            Name = _stream.Name;
            SkeletonBody body = _stream.Body;
            if (!ReferenceEquals(body, Body))
            {
                Body = body;
                BodyVersion++;
            }

            PoseOrigin origin = _buffer.Sample(_sampling.Resamples ? Time : Time + BeyondAll, _local);
            if (origin == PoseOrigin.None)
                return;

            PoseOrigin = origin;
            HasPose = true;
            ForwardKinematics.ToWorld(_local, _world, Body.Variant);
            UpdateContacts(now);
        }

        internal void Release() => _stream.Detach(_buffer);

        private static int CheckedIndex(Bone bone) => (uint)bone < BoneHierarchy.BoneCount
            ? (int)bone
            : throw new ArgumentOutOfRangeException(nameof(bone), bone, "The bone does not exist.");

        private void Resample(in SamplingSettings sampling)
        {
            _stream.Detach(_buffer);
            _sampling = sampling;
            _buffer = sampling.CreateBuffer();
            _stream.Attach(_buffer);
        }

        private void UpdateContacts(long now)
        {
            long shown = now - SourceClock.ToTicks(_sampling.Delay);
            FootContacts? measured = _stream.Contacts.Find(shown - SourceClock.ToTicks(OldestContacts), shown);
            HasMeasuredContacts = measured != null;

            // Of the newest frame, shown again, every foot stands still.
            long frames = _stream.Frames;
            if (measured == null && !_sampling.Resamples && frames == _framesShown)
                return;

            _framesShown = frames;
            Contacts = _estimator.Update(_world, Body, Time, measured);
        }
    }
}
