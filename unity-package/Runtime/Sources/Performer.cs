#nullable enable

using System;
using NeuronMocap.Motion;
using NeuronMocap.Skeleton;
using Quaternion = UnityEngine.Quaternion;
using Vector3 = UnityEngine.Vector3;

namespace NeuronMocap.Unity
{
    /// <summary>
    /// A performer of a <see cref="MocapSource"/>: its identity, and its pose in this rendered frame. The source creates performers and updates them
    /// once in each Update, before other scripts run. Main thread only.
    /// </summary>
    public sealed class Performer
    {
        // The maximum age of contacts that are used, in seconds of motion.
        private const double OldestContacts = 0.3;

        // Later than any frame, so that the buffer returns the newest one.
        private const double BeyondAll = 3600;

        private readonly AvatarStream _stream;
        private readonly FootContactEstimator _estimator = new FootContactEstimator();
        private readonly BoneTransform[] _local = new BoneTransform[BoneHierarchy.BoneCount];
        private readonly BoneTransform[] _world = new BoneTransform[BoneHierarchy.BoneCount];
        private PoseBuffer _buffer;
        private SamplingSettings _sampling;
        private StagePlacement _placement;
        private SkeletonBody _streamedBody;
        private long _framesShown;

        internal Performer(AvatarStream stream, in SamplingSettings sampling, in StagePlacement placement)
        {
            _stream = stream;
            _sampling = sampling;
            _placement = placement;
            _buffer = sampling.CreateBuffer();
            _streamedBody = stream.Body;
            Body = placement.Apply(_streamedBody);
            Name = stream.Name;
            Body.CopyRestPose(_local);
            ForwardKinematics.ToWorld(_local, _world, Body.Variant);
            _stream.Attach(_buffer);
        }

        /// <summary>Gets the number of the performer on the server, from 0.</summary>
        public int AvatarIndex => _stream.AvatarIndex;

        /// <summary>Gets the name of the performer on the server, as of the newest frame.</summary>
        public string Name { get; private set; }

        /// <summary>Gets the number of the sender of the frames. Over UDP, 0 is the first computer that sent; otherwise it is always 0.</summary>
        public int Sender => _stream.Sender;

        /// <summary>
        /// Gets the timecode of the newest frame, or null if the server sends none. Only Axis Studio sends timecodes. How the sub-frame relates to a
        /// frame rate is unknown.
        /// </summary>
        public Timecode? Timecode => _stream.Timecode;

        /// <summary>Gets whether frames arrive: the newest frame is younger than the source's idle timeout.</summary>
        public bool IsLive { get; private set; }

        /// <summary>Gets the time since the newest frame arrived, in seconds.</summary>
        public float SecondsSinceFrame { get; private set; }

        /// <summary>Gets the frame rate, averaged over the last few frames. 0 while no frames arrive.</summary>
        public double FrameRate => IsLive && _buffer.FrameInterval > 0 ? 1 / _buffer.FrameInterval : 0;

        /// <summary>Gets the number of rejected frames: a value was not a number, or a position was more than 100 km away.</summary>
        public long RejectedFrames => _stream.Rejected;

        /// <summary>
        /// Gets the delay from the arrival of a frame to the frame on the screen, in seconds. It is the source's delay, or the age of the
        /// newest frame if that is longer.
        /// </summary>
        public float Latency => Math.Max(_sampling.Delay, SecondsSinceFrame);

        /// <summary>
        /// Gets the delay that hides the jitter of the stream, in seconds: one frame plus four times the mean deviation of the arrivals. A shorter
        /// <see cref="MocapSource.Delay"/> makes frames late.
        /// </summary>
        public float NeededDelay => (float)(_buffer.FrameInterval + (4 * _buffer.Jitter));

        /// <summary>Gets how far frames arrive from their even times, in seconds, as a mean over the latest frames.</summary>
        public float Jitter => (float)_buffer.Jitter;

        /// <summary>
        /// Gets the number of frames that arrived too late to be shown at their time. It starts again when a timing setting of the source changes. 0
        /// while the source does not resample.
        /// </summary>
        public long LateFrames => _sampling.Resamples ? _buffer.Late : 0;

        /// <summary>
        /// Gets the sizes of the performer, from the stream or the command channel, or else the default sizes. The scale of the source's stage applies.
        /// </summary>
        public SkeletonBody Body { get; private set; }

        /// <summary>Gets a number that increases whenever <see cref="Body"/> changes.</summary>
        public int BodyVersion { get; private set; }

        /// <summary>Gets the skeleton variant.</summary>
        public SkeletonVariant Variant => Body.Variant;

        /// <summary>Gets whether there is a pose. True from the first frame on.</summary>
        public bool HasPose { get; private set; }

        /// <summary>
        /// Gets the pose of this rendered frame: 59 transforms relative to their parents in <see cref="Bone"/> order, in the stream's axes and
        /// centimetres. The hips are relative to the world, where <see cref="MocapSource.Stage"/> puts them. Valid until the next rendered frame. Before
        /// <see cref="HasPose"/> is true, it is the rest pose.
        /// </summary>
        public ReadOnlySpan<BoneTransform> LocalPose => _local;

        /// <summary>Gets the pose like <see cref="LocalPose"/>, with each bone relative to the stream's world.</summary>
        public ReadOnlySpan<BoneTransform> WorldPose => _world;

        /// <summary>Gets how the pose was computed: between frames, ahead of them, or from a single frame.</summary>
        public PoseOrigin PoseOrigin { get; private set; }

        /// <summary>Gets the feet that touch the ground in this pose: measured if the server sends calculation data, otherwise estimated.</summary>
        public FootContacts Contacts { get; private set; }

        /// <summary>Gets whether <see cref="Contacts"/> was measured by the server.</summary>
        public bool HasMeasuredContacts { get; private set; }

        /// <summary>
        /// Gets the position of a joint, in Unity's axes, where <see cref="MocapSource.Stage"/> puts it. Without such settings, it is relative to the
        /// origin of the mocap stage.
        /// </summary>
        /// <param name="bone">The bone.</param>
        /// <returns>The position in metres.</returns>
        /// <exception cref="ArgumentOutOfRangeException">The bone is not defined.</exception>
        public Vector3 GetPosition(Bone bone) => _world[CheckedIndex(bone)].Position.ToUnityPosition();

        /// <summary>Gets the rotation of a bone, in Unity's axes, relative to the T-pose facing +Z.</summary>
        /// <param name="bone">The bone.</param>
        /// <returns>The rotation on the mocap stage. It is the identity in the T-pose.</returns>
        /// <exception cref="ArgumentOutOfRangeException">The bone is not defined.</exception>
        public Quaternion GetRotation(Bone bone) => _world[CheckedIndex(bone)].Rotation.ToUnityRotation();

        /// <summary>
        /// Gets the end of a bone without children, such as the top of the head or the tip of a foot. For other bones, it is the joint itself.
        /// </summary>
        /// <param name="bone">The bone.</param>
        /// <returns>The position in metres, in the same space as <see cref="GetPosition"/>.</returns>
        /// <exception cref="ArgumentOutOfRangeException">The bone is not defined.</exception>
        public Vector3 GetEndPosition(Bone bone)
        {
            int index = CheckedIndex(bone);
            return _world[index].TransformPoint(Body.EndSites[index]).ToUnityPosition();
        }

        /// <summary>Returns name and number.</summary>
        /// <returns>Text for a list.</returns>
        public override string ToString() => $"{Name} ({AvatarIndex})";

        internal AvatarStream Stream => _stream;

        // As received, without the source's stage.
        internal BoneTransform StreamedHips { get; private set; }

        // Where the origin of the source's stage is, in the stream's axes.
        internal System.Numerics.Vector3 StageOffset => _placement.Offset;

        // Increases when the performer's place changes without a movement.
        internal int PlacementVersion { get; private set; }

        internal SamplingSettings Sampling => _sampling;

        // Brings another pose of this performer, as received, to the source's stage.
        internal void PlaceOnStage(Span<BoneTransform> pose) => _placement.TryApply(pose);

        // The time of this rendered frame, in seconds of SourceClock.
        internal double Time { get; private set; }

        // now: ticks of SourceClock.
        internal void Update(long now, double idleTimeout, in SamplingSettings sampling, in StagePlacement placement)
        {
            if (!_sampling.Equals(sampling))
                Resample(sampling);

            Time = SourceClock.ToSeconds(now);
            SecondsSinceFrame = (float)Math.Max(0, Time - SourceClock.ToSeconds(_stream.LastArrival));
            IsLive = SecondsSinceFrame < idleTimeout;
            Name = _stream.Name;
            Place(placement);
            PoseOrigin origin = _buffer.Sample(_sampling.Resamples ? Time : Time + BeyondAll, _local);
            if (origin == PoseOrigin.None)
                return;

            PoseOrigin = origin;
            HasPose = true;
            StreamedHips = _local[0];
            ForwardKinematics.ToWorld(_local, _world, Body.Variant);
            UpdateContacts();
            if (_placement.TryApply(_local))
                ForwardKinematics.ToWorld(_local, _world, Body.Variant);
        }

        internal void Release() => _stream.Detach(_buffer);

        private static int CheckedIndex(Bone bone) => (uint)bone < BoneHierarchy.BoneCount
            ? (int)bone
            : throw new ArgumentOutOfRangeException(nameof(bone), bone, "The bone must be one of the 59 bones, 0 to 58.");

        private void Place(in StagePlacement placement)
        {
            SkeletonBody body = _stream.Body;
            bool isNewBody = !ReferenceEquals(body, _streamedBody) || !_placement.ResizesLike(placement);
            if (!_placement.Equals(placement))
                PlacementVersion++;

            _placement = placement;
            if (!isNewBody)
                return;

            _streamedBody = body;
            Body = placement.Apply(body);
            BodyVersion++;
        }

        private void Resample(in SamplingSettings sampling)
        {
            _stream.Detach(_buffer);
            _sampling = sampling;
            _buffer = sampling.CreateBuffer();
            _stream.Attach(_buffer);
        }

        private void UpdateContacts()
        {
            long shown = _buffer.SampledTag;
            long oldest = shown - (_buffer.FrameInterval > 0 ? (long)(OldestContacts / _buffer.FrameInterval) : 0);
            FootContacts? measured = _stream.Contacts.Find(oldest, shown);
            HasMeasuredContacts = measured != null;

            // If the newest frame is shown again, every foot seems to stand still.
            long frames = _stream.Frames;
            if (measured == null && !_sampling.Resamples && frames == _framesShown)
                return;

            _framesShown = frames;
            Contacts = _placement.Apply(_estimator.Update(_world, _streamedBody, Time, measured));
        }
    }
}
