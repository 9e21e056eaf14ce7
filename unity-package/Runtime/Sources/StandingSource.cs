#nullable enable

using System;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;
using Quaternion = System.Numerics.Quaternion;
using Vector3 = System.Numerics.Vector3;

namespace NeuronMocap.Unity
{
    // The default body at its own place, standing in the T-pose or bending one joint after the other.
    internal sealed class StandingSource : MotionSource
    {
        private const float Distance = 150; // cm
        private const float Bend = 40 * MathF.PI / 180;
        private const double SecondsPerBend = 1;

        private readonly int _performer;
        private readonly bool _bends;

        public StandingSource(double frameRate, int performer, bool bends)
        {
            FrameRate = frameRate;
            _performer = performer;
            _bends = bends;
        }

        public override double FrameRate { get; }

        public override long? FrameCount => null;

        public override bool HasDisplacement => true;

        public override FootContacts GetFootContacts(long frame) => new FootContacts(true, true);

        public override void GetPose(long frame, Span<BoneTransform> pose)
        {
            SkeletonBody.GetDefault().CopyRestPose(pose);
            pose[0] = new BoneTransform(pose[0].Position + new Vector3(_performer * Distance, 0, 0), Quaternion.Identity);
            if (!_bends)
                return;

            // Each bone bends three times: about X, Y and Z, there and back.
            double bends = frame / FrameRate / SecondsPerBend;
            int bone = (int)(bends / 3 % BoneHierarchy.BoneCount);
            float angle = Bend * MathF.Sin((float)(bends % 1) * 2 * MathF.PI);
            var axis = (int)(bends % 3) switch { 0 => Vector3.UnitX, 1 => Vector3.UnitY, _ => Vector3.UnitZ };
            pose[bone] = new BoneTransform(pose[bone].Position, Quaternion.CreateFromAxisAngle(axis, angle));
        }
    }
}
