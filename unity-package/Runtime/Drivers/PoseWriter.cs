#nullable enable

using System;
using NeuronMocap.Retargeting;
using UnityEngine;
using Quaternion = UnityEngine.Quaternion;
using Vector3 = UnityEngine.Vector3;

namespace NeuronMocap.Unity
{
    // Writes poses to transforms. With a weight below 1, it mixes them with the pose of other components, usually an Animator. An Animator may write in
    // some frames only: in fixed updates, or while the figure is visible. Its last pose counts until it writes again. If no other component has
    // written, the rest pose counts. Main thread.
    internal sealed class PoseWriter
    {
        private readonly Transform[] _nodes;
        private readonly int _hips;
        private readonly bool[] _isBetween;
        private readonly bool[] _isWritten;
        private readonly Quaternion[] _rest;
        private readonly Quaternion[] _others;
        private readonly Quaternion[] _written;
        private readonly Vector3 _hipsRest;
        private Vector3 _hipsOthers;
        private Vector3 _hipsWritten;
        private bool _hasBegun;

        public PoseWriter(Transform[] nodes, TargetRig rig)
        {
            _nodes = nodes;
            _hips = rig.HipsNode;
            _isBetween = new bool[nodes.Length];
            _isWritten = new bool[nodes.Length];
            _rest = new Quaternion[nodes.Length];
            _written = new Quaternion[nodes.Length];
            for (int node = 0; node < nodes.Length; node++)
            {
                _isBetween[node] = rig.GetHumanoidBone(node) is null && rig.GetBone(node) is null;
                _rest[node] = rig.Nodes[node].Rotation.ToUnity();

                // The pose that the figure has in the scene counts as nobody's.
                _written[node] = nodes[node].localRotation;
            }

            _others = (Quaternion[])_rest.Clone();
            _hipsOthers = _hipsRest = rig.Nodes[_hips].Position.ToUnity();
            _hipsWritten = nodes[_hips].localPosition;
        }

        public void Write(RetargetedPose pose, float weight)
        {
            if (!_hasBegun)
                Begin();

            Span<System.Numerics.Quaternion> rotations = pose.LocalRotations;
            for (int node = 0; node < _nodes.Length; node++)
            {
                if (!pose.IsDriven(node))
                    Release(node, _others[node], _hipsOthers);
                else if (_nodes[node] != null)
                    Turn(node, rotations[node].ToUnity(), weight);
            }

            if (pose.IsDriven(_hips) && _nodes[_hips] != null)
                Move(pose.HipsLocalPosition.ToUnity(), weight);
        }

        // Before the next pose, intermediate transforms return to rest once more.
        public void End() => _hasBegun = false;

        // Returns driven transforms to rest.
        public void Restore()
        {
            for (int node = 0; node < _nodes.Length; node++)
                Release(node, _rest[node], _hipsRest);
        }

        // Takes the driven transforms as they stand for written by this object, after another part of the package has changed them.
        public void Adopt()
        {
            for (int node = 0; node < _nodes.Length; node++)
            {
                if (_isWritten[node] && _nodes[node] != null)
                    _written[node] = _nodes[node].localRotation;
            }

            if (_isWritten[_hips] && _nodes[_hips] != null)
                _hipsWritten = _nodes[_hips].localPosition;
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

        // A bone that is no longer driven belongs to other components. It returns to the given pose unless another component has moved it.
        private void Release(int node, Quaternion rotation, Vector3 position)
        {
            if (!_isWritten[node])
                return;

            _isWritten[node] = false;
            Transform transform = _nodes[node];
            if (transform == null)
                return;

            if (transform.localRotation.Equals(_written[node]))
            {
                transform.localRotation = rotation;
                _written[node] = transform.localRotation;
            }

            if (node == _hips && transform.localPosition.Equals(_hipsWritten))
            {
                transform.localPosition = position;
                _hipsWritten = transform.localPosition;
            }
        }

        private void Turn(int node, Quaternion rotation, float weight)
        {
            // Equals compares exactly; == ignores differences of less than a quarter of a degree.
            Transform transform = _nodes[node];
            Quaternion present = transform.localRotation;
            if (!present.Equals(_written[node]))
                _others[node] = present;

            // Reads the value back, because Unity normalises it.
            transform.localRotation = weight < 1 ? Quaternion.Slerp(_others[node], rotation, weight) : rotation;
            _written[node] = transform.localRotation;
            _isWritten[node] = true;
        }

        private void Move(Vector3 position, float weight)
        {
            Transform hips = _nodes[_hips];
            Vector3 present = hips.localPosition;
            if (!present.Equals(_hipsWritten))
                _hipsOthers = present;

            hips.localPosition = weight < 1 ? Vector3.Lerp(_hipsOthers, position, weight) : position;
            _hipsWritten = hips.localPosition;
        }
    }
}
