#nullable enable

using System;
using NeuronMocap.Skeleton;
using Vector3 = System.Numerics.Vector3;

namespace NeuronMocap.Unity
{
    // The place of the figure on the stage of its source.
    public abstract partial class FigureDriver
    {
        [NonSerialized]
        private BoneTransform[]? _placed;

        // The figure's steps are scaled, but the distance of its stage is not.
        private ReadOnlySpan<BoneTransform> PlaceOnStage(Performer performer, ReadOnlySpan<BoneTransform> pose, FigureRig rig)
        {
            Vector3 offset = performer.StageOffset;
            float scale = rig.Scale;
            if (offset == default || scale == 1 || !(scale > 0))
                return pose;

            _placed ??= new BoneTransform[BoneHierarchy.BoneCount];
            pose.CopyTo(_placed);
            _placed[0] = new BoneTransform(pose[0].Position + (offset * ((1 / scale) - 1)), pose[0].Rotation);
            return _placed;
        }
    }
}
