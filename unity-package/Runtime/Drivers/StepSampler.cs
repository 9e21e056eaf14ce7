#nullable enable

using System;
using NeuronMocap.Motion;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Unity
{
    // The poses of a performer at the times of physics steps. Several steps may belong to one rendered frame, and each needs its own pose. It has its
    // own buffer, because the performer's buffer is read at the times of the rendered frames. Main thread.
    internal sealed class StepSampler
    {
        private readonly BoneTransform[] _pose = new BoneTransform[BoneHierarchy.BoneCount];
        private Performer? _performer;
        private PoseBuffer? _buffer;
        private SamplingSettings _sampling;

        public ReadOnlySpan<BoneTransform> Sample(Performer performer, double seconds)
        {
            if (!performer.Sampling.Resamples)
            {
                Release();
                return performer.LocalPose;
            }

            if (_performer != performer || !_sampling.Equals(performer.Sampling))
                Attach(performer);

            // Until frames have arrived here, too.
            if (_buffer!.Sample(seconds, _pose) == PoseOrigin.None)
                return performer.LocalPose;

            performer.PlaceOnStage(_pose);
            return _pose;
        }

        public void Release()
        {
            if (_buffer != null)
                _performer!.Stream.Detach(_buffer);

            (_performer, _buffer) = (null, null);
        }

        private void Attach(Performer performer)
        {
            Release();
            _performer = performer;
            _sampling = performer.Sampling;
            _buffer = _sampling.CreateBuffer();
            performer.Stream.Attach(_buffer);
        }
    }
}
