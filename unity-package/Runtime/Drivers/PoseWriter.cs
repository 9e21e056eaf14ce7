#nullable enable

using System;
using NeuronMocap.Retargeting;
using UnityEngine;
using Quaternion = UnityEngine.Quaternion;
using Vector3 = UnityEngine.Vector3;

namespace NeuronMocap.Unity
{
    // Writes poses to transforms. With a weight below 1, it mixes them with the pose that another component, usually an Animator, wrote in the
    // meantime. If there is no such pose, it mixes them with the rest pose. Main thread.
    internal sealed class PoseWriter
    {
        private readonly Transform[] _nodes;
        private readonly int _hips;
        private readonly Quaternion[] _rest;
        private readonly Quaternion[] _written;
        private readonly bool[] _isWritten;
        private readonly bool[] _isBetween;
        private readonly Vector3 _hipsRest;
        private Vector3 _hipsWritten;
        private bool _hasBegun;

        public PoseWriter(Transform[] nodes, TargetRig rig)
        {
            _nodes = nodes;
            _hips = rig.HipsNode;
            _rest = new Quaternion[nodes.Length];
            _isWritten = new bool[nodes.Length];
            _isBetween = new bool[nodes.Length];
            Skipped = new bool[nodes.Length];
            for (int node = 0; node < nodes.Length; node++)
            {
                _rest[node] = rig.Nodes[node].Rotation.ToUnity();
                _isBetween[node] = rig.GetHumanoidBone(node) is null && rig.GetBone(node) is null;
            }

            _written = (Quaternion[])_rest.Clone();
            _hipsWritten = _hipsRest = rig.Nodes[_hips].Position.ToUnity();
        }

        // Transforms that another writer moves.
        public bool[] Skipped { get; }

        public void Write(RetargetedPose pose, float weight)
        {
            if (!_hasBegun)
                Begin();

            Span<System.Numerics.Quaternion> rotations = pose.LocalRotations;
            for (int node = 0; node < _nodes.Length; node++)
            {
                if (Skipped[node])
                    continue;
                if (!pose.IsDriven(node))
                    Release(node);
                else if (_nodes[node] != null)
                    Turn(node, rotations[node].ToUnity(), weight);
            }

            if (pose.IsDriven(_hips) && !Skipped[_hips] && _nodes[_hips] != null)
                Move(pose.HipsLocalPosition.ToUnity(), weight);
        }

        // Before the next pose, intermediate transforms return to rest once more.
        public void End() => _hasBegun = false;

        // Returns driven transforms to rest.
        public void Restore()
        {
            for (int node = 0; node < _nodes.Length; node++)
                Release(node);
        }

        // Poses assume that intermediate transforms, such as twist bones, are at rest, whatever their pose in the scene was. After that, other
        // components may move them.
        private void Begin()
        {
            _hasBegun = true;
            for (int node = 0; node < _nodes.Length; node++)
            {
                if (_isBetween[node] && _nodes[node] != null)
                    _nodes[node].localRotation = _rest[node];
            }
        }

        // A bone that is no longer driven belongs to other components. It returns to rest unless another component has moved it.
        private void Release(int node)
        {
            if (!_isWritten[node])
                return;

            _isWritten[node] = false;
            Transform transform = _nodes[node];
            if (transform == null)
                return;

            if (transform.localRotation.Equals(_written[node]))
                transform.localRotation = _rest[node];
            if (node == _hips && transform.localPosition.Equals(_hipsWritten))
                transform.localPosition = _hipsRest;
            _written[node] = _rest[node];
        }

        private void Turn(int node, Quaternion rotation, float weight)
        {
            Transform transform = _nodes[node];
            if (weight < 1)
            {
                Quaternion present = transform.localRotation;
                rotation = Quaternion.Slerp(present.Equals(_written[node]) ? _rest[node] : present, rotation, weight);
            }

            // Reads the value back, because Unity normalises it. Equals compares exactly; == ignores differences of less than a quarter of a degree.
            transform.localRotation = rotation;
            _written[node] = transform.localRotation;
            _isWritten[node] = true;
        }

        private void Move(Vector3 position, float weight)
        {
            Transform hips = _nodes[_hips];
            if (weight < 1)
            {
                Vector3 present = hips.localPosition;
                position = Vector3.Lerp(present.Equals(_hipsWritten) ? _hipsRest : present, position, weight);
            }

            hips.localPosition = position;
            _hipsWritten = hips.localPosition;
        }
    }
}
