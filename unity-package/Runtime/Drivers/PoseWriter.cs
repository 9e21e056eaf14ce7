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
        private readonly bool[] _isBetween;
        private readonly bool[] _isTurned;
        private readonly Quaternion[] _restRotations;
        private readonly Quaternion[] _othersRotations;
        private readonly Quaternion[] _writtenRotations;
        private readonly bool[] _isMoved;
        private readonly Vector3[] _restPositions;
        private readonly Vector3[] _othersPositions;
        private readonly Vector3[] _writtenPositions;
        private bool _hasBegun;

        public PoseWriter(Transform[] nodes, TargetRig rig)
        {
            _nodes = nodes;
            _isTurned = new bool[nodes.Length];
            _isMoved = new bool[nodes.Length];
            _isBetween = new bool[nodes.Length];
            Skipped = new bool[nodes.Length];
            _restRotations = new Quaternion[nodes.Length];
            _restPositions = new Vector3[nodes.Length];
            for (int node = 0; node < nodes.Length; node++)
            {
                _isBetween[node] = rig.GetHumanoidBone(node) is null && rig.GetBone(node) is null;
                _restRotations[node] = rig.Nodes[node].Rotation.ToUnity();
                _restPositions[node] = rig.Nodes[node].Position.ToUnity();
            }

            _othersRotations = (Quaternion[])_restRotations.Clone();
            _othersPositions = (Vector3[])_restPositions.Clone();

            // The pose that the figure has in the scene counts as nobody's.
            _writtenRotations = Array.ConvertAll(nodes, node => node.localRotation);
            _writtenPositions = Array.ConvertAll(nodes, node => node.localPosition);
        }

        // Transforms that another writer moves.
        public bool[] Skipped { get; }

        public void Write(RetargetedPose pose, float weight)
        {
            if (!_hasBegun)
                Begin();

            Span<System.Numerics.Quaternion> rotations = pose.LocalRotations;
            Span<System.Numerics.Vector3> positions = pose.LocalPositions;
            for (int node = 0; node < _nodes.Length; node++)
            {
                Transform transform = _nodes[node];
                if (transform == null || Skipped[node])
                    continue;

                if (pose.IsDriven(node))
                    Turn(node, transform, rotations[node].ToUnity(), weight);
                else
                    ReleaseRotation(node, transform, _othersRotations);

                if (pose.IsMoved(node))
                    Move(node, transform, positions[node].ToUnity(), weight);
                else
                    ReleasePosition(node, transform, _othersPositions);
            }
        }

        // Before the next pose, intermediate transforms return to rest once more.
        public void End() => _hasBegun = false;

        // Returns driven transforms to rest.
        public void Restore()
        {
            for (int node = 0; node < _nodes.Length; node++)
            {
                if (_nodes[node] == null)
                    continue;

                ReleaseRotation(node, _nodes[node], _restRotations);
                ReleasePosition(node, _nodes[node], _restPositions);
            }
        }

        // Another writer has moved a transform, so its pose is not that of an Animator.
        public void Forget(int node)
        {
            if (_nodes[node] == null)
                return;

            _writtenRotations[node] = _nodes[node].localRotation;
            _writtenPositions[node] = _nodes[node].localPosition;
        }

        // Poses assume that intermediate transforms, such as twist bones, are at rest, whatever their pose in the scene was. After that, other
        // components may move them.
        private void Begin()
        {
            _hasBegun = true;
            for (int node = 0; node < _nodes.Length; node++)
            {
                if (_isBetween[node] && _nodes[node] != null)
                    _nodes[node].localRotation = _restRotations[node];
            }
        }

        // A bone that is no longer driven belongs to other components. It returns to the given pose unless another component has moved it.
        private void ReleaseRotation(int node, Transform transform, Quaternion[] pose)
        {
            if (!_isTurned[node])
                return;

            _isTurned[node] = false;
            if (!transform.localRotation.Equals(_writtenRotations[node]))
                return;

            transform.localRotation = pose[node];
            _writtenRotations[node] = transform.localRotation;
        }

        private void ReleasePosition(int node, Transform transform, Vector3[] pose)
        {
            if (!_isMoved[node])
                return;

            _isMoved[node] = false;
            if (!transform.localPosition.Equals(_writtenPositions[node]))
                return;

            transform.localPosition = pose[node];
            _writtenPositions[node] = transform.localPosition;
        }

        private void Turn(int node, Transform transform, Quaternion rotation, float weight)
        {
            // Equals compares exactly; == ignores differences of less than a quarter of a degree.
            Quaternion present = transform.localRotation;
            if (!present.Equals(_writtenRotations[node]))
                _othersRotations[node] = present;

            // Reads the value back, because Unity normalises it.
            transform.localRotation = weight < 1 ? Quaternion.Slerp(_othersRotations[node], rotation, weight) : rotation;
            _writtenRotations[node] = transform.localRotation;
            _isTurned[node] = true;
        }

        private void Move(int node, Transform transform, Vector3 position, float weight)
        {
            Vector3 present = transform.localPosition;
            if (!present.Equals(_writtenPositions[node]))
                _othersPositions[node] = present;

            transform.localPosition = weight < 1 ? Vector3.Lerp(_othersPositions[node], position, weight) : position;
            _writtenPositions[node] = transform.localPosition;
            _isMoved[node] = true;
        }
    }
}
