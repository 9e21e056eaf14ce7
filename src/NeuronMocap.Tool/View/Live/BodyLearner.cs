using System.Numerics;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tool.View.Live;

/// <summary>Learns the sizes of an actor from a stream with displacement.</summary>
/// <remarks>
/// New sizes must stay within the tolerance for a while before they count. A single bad frame, or a briefly stretched spine, thus changes nothing. The
/// Unity package learns in the same way. Not thread-safe.
/// </remarks>
internal sealed class BodyLearner
{
    private const float Tolerance = 0.2f; // cm
    private const int SteadyFrames = 20;

    private readonly Vector3[] _candidate = new Vector3[BoneHierarchy.BoneCount];
    private int _steady;

    /// <summary>Takes a pose.</summary>
    /// <param name="pose">59 transforms relative to the parent, with the actor's own positions.</param>
    /// <param name="variant">The variant of the stream.</param>
    /// <param name="known">The known body; null for none.</param>
    /// <param name="endSites">The body whose End Sites are used, if its variant is the same; null for the default ones.</param>
    /// <returns>The body of the pose if it differs from the known one; otherwise null.</returns>
    public SkeletonBody? Observe(ReadOnlySpan<BoneTransform> pose, SkeletonVariant variant, SkeletonBody? known, SkeletonBody? endSites)
    {
        bool isKnown = known is not null && known.Variant == variant;
        if (!IsFinite(pose) || (isKnown && !IsSteadilyOther(pose, known!)))
            return null;

        _steady = 0;
        return SkeletonBody.FromPose(pose, variant, endSites?.Variant == variant ? endSites.EndSites : default);
    }

    private bool IsSteadilyOther(ReadOnlySpan<BoneTransform> pose, SkeletonBody known)
    {
        if (IsNear(pose, known.Offsets))
        {
            _steady = 0;
            return false;
        }

        if (_steady > 0 && !IsNear(pose, _candidate))
            _steady = 0;
        if (_steady == 0)
        {
            for (int bone = 0; bone < _candidate.Length; bone++)
                _candidate[bone] = pose[bone].Position;
        }

        return ++_steady >= SteadyFrames;
    }

    private static bool IsFinite(ReadOnlySpan<BoneTransform> pose)
    {
        foreach (BoneTransform bone in pose)
        {
            if (!float.IsFinite(bone.Position.X) || !float.IsFinite(bone.Position.Y) || !float.IsFinite(bone.Position.Z))
                return false;
        }

        return true;
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
