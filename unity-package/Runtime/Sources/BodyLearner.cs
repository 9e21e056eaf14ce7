#nullable enable

using System;
using NeuronMocap.Skeleton;
using Vector3 = System.Numerics.Vector3;

namespace NeuronMocap.Unity
{
    // Learns the sizes of an actor from a stream with displacement. New sizes must stay within the tolerance for a while before they count. A single
    // bad frame, or a briefly stretched spine, thus does not rebuild figures. Receive thread.
    internal sealed class BodyLearner
    {
        private const float Tolerance = 0.2f; // cm
        private const int SteadyFrames = 20;

        private readonly Vector3[] _candidate = new Vector3[BoneHierarchy.BoneCount];
        private int _steady;

        // The body of the pose if it differs from the known one.
        public SkeletonBody? Observe(ReadOnlySpan<BoneTransform> pose, SkeletonVariant variant, SkeletonBody? known, SkeletonBody? reported)
        {
            ReadOnlySpan<Vector3> endSites = reported != null && reported.Variant == variant ? reported.EndSites : default;
            if (known == null || known.Variant != variant)
                return SkeletonBody.FromPose(pose, variant, endSites);

            if (IsNear(pose, known.Offsets))
            {
                _steady = 0;
                return null;
            }

            if (_steady > 0 && !IsNear(pose, _candidate))
                _steady = 0;
            if (_steady == 0)
            {
                for (int bone = 0; bone < _candidate.Length; bone++)
                    _candidate[bone] = pose[bone].Position;
            }

            if (++_steady < SteadyFrames)
                return null;

            _steady = 0;
            return SkeletonBody.FromPose(pose, variant, endSites);
        }

        // The position of the hips is that of the actor, so it is ignored.
        private static bool IsNear(ReadOnlySpan<BoneTransform> pose, ReadOnlySpan<Vector3> offsets)
        {
            for (int bone = 1; bone < BoneHierarchy.BoneCount; bone++)
            {
                if (Vector3.DistanceSquared(pose[bone].Position, offsets[bone]) > Tolerance * Tolerance)
                    return false;
            }

            return true;
        }
    }
}
