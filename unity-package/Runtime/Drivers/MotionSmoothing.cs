#nullable enable

using System;
using NeuronMocap.Motion;
using NeuronMocap.Retargeting;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Unity
{
    // Smooths the poses of one performer, and measures their noise before and after. Main thread.
    internal sealed class MotionSmoothing
    {
        private readonly PoseSmoother _smoother = new PoseSmoother();
        private readonly BoneTransform[] _pose = new BoneTransform[BoneHierarchy.BoneCount];
        private readonly RotationNoise _before = new RotationNoise();
        private readonly RotationNoise _after = new RotationNoise();
        private Performer? _performer;

        public ReadOnlySpan<BoneTransform> Smooth(Performer performer, ReadOnlySpan<BoneTransform> pose, double seconds, PartSmoothing settings)
        {
            if (_performer != performer)
                Reset();

            _performer = performer;
            settings.CopyTo(_smoother, performer.Variant);
            pose.Slice(0, _pose.Length).CopyTo(_pose);
            _before.Update(_pose, seconds);
            _smoother.Smooth(_pose, seconds);
            _after.Update(_pose, seconds);
            return _pose;
        }

        public void Reset()
        {
            _performer = null;
            _smoother.Reset();
            _before.Reset();
            _after.Reset();
        }

        // In degrees: the root mean square over the bones of some parts.
        public (double Before, double After) GetNoise(BodyParts parts)
        {
            (double before, double after, int count) = (0, 0, 0);
            foreach (Bone bone in BoneHierarchy.Bones)
            {
                if ((HumanoidBones.GetPart(bone) & parts) == BodyParts.None)
                    continue;

                before += Square(_before.GetDegrees(bone));
                after += Square(_after.GetDegrees(bone));
                count++;
            }

            return (Math.Sqrt(before / count), Math.Sqrt(after / count));
        }

        private static double Square(double value) => value * value;
    }
}
