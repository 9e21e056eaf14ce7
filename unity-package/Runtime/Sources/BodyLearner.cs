#nullable enable

using System;
using NeuronMocap.Skeleton;
using Vector3 = System.Numerics.Vector3;

namespace NeuronMocap.Unity
{
    // Finds the sizes of an actor in a stream with displacement. They count as others when all of them have stayed within the tolerance of new ones for
    // a while: one bad frame, or a spine that is stretched for a moment, does not build figures anew. Receive thread.
    internal sealed class BodyLearner
    {
        private const float Tolerance = 0.2f; // cm
        private const int SteadyFrames = 20;

        private readonly Vector3[] _candidate = new Vector3[BoneHierarchy.BoneCount];
        private int _steady;

        // The body of the pose, when it is another than the one that is known.
        public SkeletonBody? Observe(ReadOnlySpan<BoneTransform> pose, SkeletonVariant variant, SkeletonBody? known, SkeletonBody? told)
        {
            ReadOnlySpan<Vector3> endSites = told != null && told.Variant == variant ? told.EndSites : default;
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

        // The hips are wherever the actor is.
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
