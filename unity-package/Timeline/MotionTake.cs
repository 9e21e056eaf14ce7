#nullable enable

using System;
using System.IO;
using NeuronMocap.Bvh;
using NeuronMocap.Motion;
using NeuronMocap.Recording;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;
using UnityEngine;
using Vector3 = System.Numerics.Vector3;

namespace NeuronMocap.Unity.Timeline
{
    // A file as motion over time. All frames are in memory, so that any time can be shown at once.
    internal sealed class MotionTake
    {
        // Times that are computed from frame numbers are not exact.
        private const double SameFrame = 1e-6;

        private readonly MotionSource _source;
        private readonly long _lastFrame;
        private readonly BoneTransform[] _next = new BoneTransform[BoneHierarchy.BoneCount];

        private MotionTake(MotionSource source)
        {
            _source = source;
            _lastFrame = source.FrameCount!.Value - 1;
            Span<Vector3> offsets = stackalloc Vector3[BoneHierarchy.BoneCount];
            Span<Vector3> endSites = stackalloc Vector3[BoneHierarchy.BoneCount];
            source.GetBody(offsets, endSites);
            Body = new SkeletonBody(offsets, endSites, source.Variant);
        }

        public SkeletonBody Body { get; }

        public long FrameCount => _lastFrame + 1;

        // In frames per second.
        public double FrameRate => _source.FrameRate;

        // Empty if the file names no performer.
        public string PerformerName => _source is RecordingSource recording ? recording.AvatarName : string.Empty;

        // From the first frame to the end of the last one, in seconds.
        public double Duration => FrameCount / FrameRate;

        // A text asset: a BVH file or a recording.
        public static MotionTake Parse(byte[] content, int performer)
        {
            if (!RecordingReader.IsRecording(content))
                return new MotionTake(new BvhSource(BvhDocument.Parse(content)));

            // Recordings are read from files. The folder for temporary files of the system may be missing on phones.
            string path = Path.Combine(Application.temporaryCachePath, Path.GetRandomFileName());
            try
            {
                File.WriteAllBytes(path, content);
                return Open(path, performer);
            }
            finally
            {
                File.Delete(path);
            }
        }

        public static MotionTake Load(string path, int performer) => Path.GetExtension(path).Equals(".bvh", StringComparison.OrdinalIgnoreCase)
            ? new MotionTake(new BvhSource(BvhDocument.Load(path)))
            : Open(path, performer);

        private static MotionTake Open(string path, int performer) => new MotionTake(RecordingSource.Load(path, performer < 0 ? (int?)null : performer));

        // The pose at a time. Before and after the file, it is the first and the last pose.
        public void Sample(double seconds, Span<BoneTransform> pose)
        {
            double place = Math.Max(0, Math.Min(seconds * _source.FrameRate, _lastFrame));
            long frame = Math.Min((long)(place + SameFrame), _lastFrame);
            double part = place - frame;
            _source.GetPose(frame, pose);
            if (part <= SameFrame)
                return;

            _source.GetPose(frame + 1, _next);
            PoseInterpolation.Linear(pose.Slice(0, _next.Length), _next, part, pose);
        }
    }
}
