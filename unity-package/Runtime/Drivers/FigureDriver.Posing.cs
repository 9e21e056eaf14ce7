#nullable enable

using System;
using NeuronMocap.Skeleton;
using UnityEngine;

namespace NeuronMocap.Unity
{
    // Poses that do not come from a performer, such as those of Timeline. Also in edit mode.
    public abstract partial class FigureDriver
    {
        // Who gave the latest pose. Only this one may release the figure, because another one may have nothing to show at the time.
        [NonSerialized]
        private object? _poseOwner;

        [NonSerialized]
        private float _posedWeight;

        // While the figure has such a pose, it does not follow its performer.
        internal bool IsPosed => _poseOwner != null;

        internal bool AddPose(ReadOnlySpan<BoneTransform> pose, SkeletonBody body, float weight)
        {
            if (!TryBind())
            {
                Problem = _rigProblem!;
                return false;
            }

            FigureRig rig = _rig!;
            rig.SetBody(body);
            _retargeted = null;
            SetOptions(rig);
            if (!rig.TryRetarget(pose))
                return false;

            rig.Mix.Add(rig.Pose, weight);
            return true;
        }

        // Moves the figure to the mean of the poses that were added.
        internal void EndPose(object owner)
        {
            FigureRig rig = _rig!;
            SaveScene(rig);
            rig.Mix.CopyTo(rig.Pose);
            rig.Bodies.End();
            _posedWeight = Mathf.Clamp01(_weight) * Mathf.Clamp01(rig.Mix.Weight);
            rig.Writer.Write(rig.Pose, _posedWeight);
            rig.Mix.Clear();
            _poseOwner = owner;
            _hasPose = true;
        }

        // An Animator may have written after Timeline. The pose is no longer there once the figure was bound again.
        private void KeepPose()
        {
            if (IsPosed && _hasPose)
                _rig?.Writer.Write(_rig.Pose, _posedWeight);
        }

        // In edit mode, the figure returns to its pose in the scene. In play mode, it follows its performer again.
        internal void ReleasePose(object owner)
        {
            if (_poseOwner != owner)
                return;

            _poseOwner = null;
            if (!Application.isPlaying)
                Rebind();
        }
    }
}
