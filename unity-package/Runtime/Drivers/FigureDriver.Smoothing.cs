#nullable enable

using System;

namespace NeuronMocap.Unity
{
    // The motion between the performer and the retargeter.
    public abstract partial class FigureDriver
    {
        [NonSerialized]
        private MotionSmoothing? _motionSmoothing;

        /// <summary>
        /// Gets or sets whether the motion is smoothed before the figure follows it. Smoothing removes noise and adds a delay, which the inspector
        /// shows. The default is false.
        /// </summary>
        public bool Smoothing
        {
            get => _smoothing;
            set => _smoothing = value;
        }

        /// <summary>Gets how strongly each part of the body is smoothed while <see cref="Smoothing"/> is on.</summary>
        public PartSmoothing PartSmoothing => _partSmoothing;

        // Null while the motion is not smoothed.
        internal MotionSmoothing? ActiveSmoothing => _smoothing ? _motionSmoothing : null;

        private ReadOnlySpan<BoneTransform> PoseOf(Performer performer)
        {
            double time = TimeOf(performer);
            ReadOnlySpan<BoneTransform> pose = _isStep ? _stepSampler.Sample(performer, time) : performer.LocalPose;
            if (!_smoothing)
            {
                _motionSmoothing?.Reset();
                return pose;
            }

            _motionSmoothing ??= new MotionSmoothing();
            return _motionSmoothing.Smooth(performer, pose, time, _partSmoothing);
        }
    }
}
