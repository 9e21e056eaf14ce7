#nullable enable

using System;
using NeuronMocap.Motion;
using NeuronMocap.Skeleton;
using UnityEditor;

namespace NeuronMocap.Unity.EditorTools
{
    // Collects the frames of a performer while an inspector shows them. A fast stream may bring two frames within one update of the editor; then it
    // takes the second one.
    internal sealed class HistoryWatch : IDisposable
    {
        // Later than any frame, so that the buffer returns the newest one.
        private const double BeyondAll = 3600;

        private readonly Func<Performer?> _find;
        private readonly BoneTransform[] _pose = new BoneTransform[BoneHierarchy.BoneCount];
        private Performer? _performer;
        private PoseBuffer? _buffer;

        public HistoryWatch(Func<Performer?> find)
        {
            _find = find;
            EditorApplication.update += Update;
        }

        public MotionHistory History { get; } = new MotionHistory();

        // Off: the frames are not collected, and what was collected is forgotten.
        public bool IsOn { get; set; }

        // Null while there is no motion.
        public Performer? Performer => _performer is { IsLive: true } ? _performer : null;

        public void Dispose()
        {
            EditorApplication.update -= Update;
            Attach(null);
        }

        private void Update()
        {
            Performer? found = IsOn ? _find() : null;
            if (found != _performer)
                Attach(found);

            if (_buffer is null || _buffer.Sample(SourceClock.ToSeconds(SourceClock.Now) + BeyondAll, _pose) == PoseOrigin.None)
                return;

            History.Add(SourceClock.ToSeconds(_performer!.Stream.LastArrival), _pose);
        }

        private void Attach(Performer? performer)
        {
            if (_buffer != null)
                _performer!.Stream.Detach(_buffer);

            History.Clear();
            _performer = performer;
            _buffer = performer is null ? null : new SamplingSettings(false, 0, PoseInterpolationMethod.Linear).CreateBuffer();
            if (_buffer != null)
                performer!.Stream.Attach(_buffer);
        }
    }
}
