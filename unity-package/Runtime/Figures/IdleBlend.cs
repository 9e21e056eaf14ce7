#nullable enable
using System.Collections.Generic;
using UnityEngine;
using Quaternion = UnityEngine.Quaternion;
using Vector3 = UnityEngine.Vector3;

namespace NeuronMocap.Unity
{
    // Blends a humanoid from its driver's pose to standing with arms down, and back. Runs after the driver. Each blend starts at a snapshot of the
    // character.
    internal sealed class IdleBlend
    {
        // The angle of the arms below the horizontal.
        private const float ArmsDown = 75 * Mathf.Deg2Rad;

        private readonly Transform _root;
        private readonly List<Transform> _bones = new List<Transform>();
        private readonly Quaternion[] _idle;
        private readonly Quaternion[] _from;
        private readonly Vector3 _restHips;
        private readonly Quaternion _restHipsRotation;
        private Vector3 _idleHips;
        private Vector3 _fromHips;
        private float _progress = 1;
        private bool _isIdle;

        // animator: a humanoid still in its rest pose.
        public IdleBlend(Animator animator)
        {
            _root = animator.transform;
            for (HumanBodyBones human = HumanBodyBones.Hips; human < HumanBodyBones.LastBone; human++)
            {
                Transform? bone = animator.GetBoneTransform(human);
                if (bone != null)
                    _bones.Add(bone);
            }

            _idle = new Quaternion[_bones.Count];
            _from = new Quaternion[_bones.Count];
            for (int i = 0; i < _bones.Count; i++)
                _idle[i] = _bones[i].localRotation;

            _restHips = HipsPosition;
            _restHipsRotation = HipsRotation;
            Lower(animator, HumanBodyBones.LeftUpperArm, HumanBodyBones.LeftLowerArm, -1);
            Lower(animator, HumanBodyBones.RightUpperArm, HumanBodyBones.RightLowerArm, 1);
        }

        // The first bone of the enumeration. Every human has hips.
        private Transform Hips => _bones[0];

        private Vector3 HipsPosition => _root.InverseTransformPoint(Hips.position);

        private Quaternion HipsRotation => Quaternion.Inverse(_root.rotation) * Hips.rotation;

        // Starts the blend to the idle pose, when data stops.
        public void Leave()
        {
            TakeSnapshot();
            _isIdle = true;

            // Upright at its current place and heading.
            _idleHips = new Vector3(_fromHips.x, _restHips.y, _fromHips.z);
            Vector3 forward = HipsRotation * Quaternion.Inverse(_restHipsRotation) * Vector3.forward;
            forward.y = 0;
            Quaternion heading = forward.sqrMagnitude > 1e-4f ? Quaternion.LookRotation(forward, Vector3.up) : Quaternion.identity;
            _idle[0] = Quaternion.Inverse(Hips.parent!.rotation) * _root.rotation * heading * _restHipsRotation;
        }

        // Starts the blend back, when data resumes.
        public void Return()
        {
            TakeSnapshot();
            _isIdle = false;
        }

        // Runs in each frame, after the animator and the driver. step: the fraction of the blend to add. Returns whether it moved the character.
        public bool Apply(float step)
        {
            _progress = Mathf.Min(1, _progress + step);
            if (_progress >= 1 && !_isIdle)
                return false;

            float part = Mathf.SmoothStep(0, 1, _progress);
            Vector3 hips = Vector3.Lerp(_fromHips, _isIdle ? _idleHips : HipsPosition, part);
            for (int i = 0; i < _bones.Count; i++)
                _bones[i].localRotation = Quaternion.Slerp(_from[i], _isIdle ? _idle[i] : _bones[i].localRotation, part);

            Hips.position = _root.TransformPoint(hips);
            return true;
        }

        private void TakeSnapshot()
        {
            for (int i = 0; i < _bones.Count; i++)
                _from[i] = _bones[i].localRotation;

            _fromHips = HipsPosition;
            _progress = 0;
        }

        // Lowers an arm from any rest pose. Left is at negative X.
        private void Lower(Animator animator, HumanBodyBones upper, HumanBodyBones lower, float side)
        {
            Transform arm = animator.GetBoneTransform(upper)!;
            Vector3 direction = _root.InverseTransformDirection(animator.GetBoneTransform(lower)!.position - arm.position);
            var down = new Vector3(side * Mathf.Cos(ArmsDown), -Mathf.Sin(ArmsDown), 0);
            Quaternion parent = Quaternion.Inverse(_root.rotation) * arm.parent!.rotation;
            int index = _bones.IndexOf(arm);
            _idle[index] = Quaternion.Inverse(parent) * Quaternion.FromToRotation(direction, down) * parent * _idle[index];
        }
    }
}
