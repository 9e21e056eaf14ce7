#nullable enable

using System;
using NeuronMocap.Retargeting;
using UnityEngine;
using Numerics = System.Numerics;
using Quaternion = UnityEngine.Quaternion;
using Vector3 = UnityEngine.Vector3;

namespace NeuronMocap.Unity
{
    // Moves a figure in physics steps. Bones with a kinematic Rigidbody move through physics, and the others as PoseWriter moves them. Main thread, in
    // FixedUpdate.
    internal sealed class BodyWriter
    {
        private readonly Transform[] _nodes;
        private readonly TargetRig _rig;
        private readonly PoseWriter _writer;
        private readonly RetargetedPose _target;
        private readonly Rigidbody?[] _bodies;
        private readonly bool[] _isCarried;
        private readonly Pose[] _before;
        private Rigidbody? _loose;
        private bool _isHeld;
        private bool _hasBegun;

        public BodyWriter(Transform[] nodes, TargetRig rig, PoseWriter writer)
        {
            _nodes = nodes;
            _rig = rig;
            _writer = writer;
            _target = new RetargetedPose(rig);
            _bodies = new Rigidbody?[nodes.Length];
            _isCarried = new bool[nodes.Length];
            _before = new Pose[nodes.Length];
        }

        // Empty if there is no problem.
        public string Problem { get; private set; } = string.Empty;

        // Before something moves the figure's root in this step, and all bodies with it.
        public void Hold(RetargetedPose pose)
        {
            FindBodies(pose);
            for (int node = 0; node < _nodes.Length; node++)
            {
                _isCarried[node] = _bodies[node] != null;
                Capture(node);
            }

            _isHeld = true;
        }

        public void Write(RetargetedPose pose, float weight)
        {
            // A transform that moves takes the bodies below it along, without a velocity. They return to where they were, and then move through physics.
            if (!_isHeld)
            {
                FindBodies(pose);
                for (int node = 0; node < _nodes.Length; node++)
                    Capture(node);
            }

            _isHeld = false;
            _writer.Write(pose, weight);
            for (int node = 0; node < _nodes.Length; node++)
            {
                if (_isCarried[node])
                    _nodes[node].SetPositionAndRotation(_before[node].position, _before[node].rotation);
            }

            // Otherwise physics would notice the changed transforms only at the step itself, and place the bodies instead of moving them.
            Physics.SyncTransforms();
            ComputeTarget(pose, weight);
            for (int node = 0; node < _nodes.Length; node++)
            {
                if (_bodies[node] is { } body && TryGetTarget(node, out Vector3 position, out Quaternion rotation))
                    KinematicMove.To(body, position, rotation, jumps: !_hasBegun);
            }

            _hasBegun = true;
        }

        // The place of a node at the end of the current physics step, in the world.
        public bool TryGetTarget(int node, out Vector3 position, out Quaternion rotation)
        {
            Transform? root = _nodes[0] != null ? _nodes[0].parent : null;
            (position, rotation) = (Vector3.zero, Quaternion.identity);
            if (root == null)
                return false;

            position = root.TransformPoint(_target.WorldPositions[node].ToUnity());
            rotation = root.rotation * _target.WorldRotations[node].ToUnity();
            return true;
        }

        // Leaves all transforms to the other writer again.
        public void End()
        {
            _isHeld = false;
            Report(null);
            if (!_hasBegun)
                return;

            _hasBegun = false;
            for (int node = 0; node < _nodes.Length; node++)
            {
                if (_bodies[node] is not null)
                    _writer.Forget(node);
            }

            Array.Clear(_bodies, 0, _bodies.Length);
            Array.Clear(_writer.Skipped, 0, _writer.Skipped.Length);
        }

        // Returns bones with a body to rest.
        public void Restore()
        {
            for (int node = 0; node < _nodes.Length; node++)
            {
                if (_bodies[node] is null || _nodes[node] == null)
                    continue;

                _nodes[node].localRotation = _rig.Nodes[node].Rotation.ToUnity();
                _nodes[node].localPosition = _rig.Nodes[node].Position.ToUnity();
            }

            End();
        }

        // Looks for bodies in each step, because components come and go at any time.
        private void FindBodies(RetargetedPose pose)
        {
            Rigidbody? loose = null;
            for (int node = 0; node < _nodes.Length; node++)
            {
                Rigidbody? body = pose.IsDriven(node) ? FindBody(_nodes[node]) : null;
                bool isBody = body is { isKinematic: true };
                if (!isBody)
                    loose ??= body;
                if (!isBody && _bodies[node] is not null)
                    _writer.Forget(node);

                _bodies[node] = isBody ? body : null;
                _writer.Skipped[node] = isBody;
                _isCarried[node] = isBody && IsBelowMovedTransform(pose, node);
            }

            Report(loose);
        }

        // A sentence for each change, not for each step.
        private void Report(Rigidbody? loose)
        {
            if (loose == _loose)
                return;

            _loose = loose;
            Problem = loose == null ? string.Empty : $"{loose.name} has a Rigidbody that is not kinematic. Physics and the driver both move it. Set Is Kinematic.";
        }

        private void Capture(int node)
        {
            if (_isCarried[node])
                _before[node] = new Pose(_nodes[node].position, _nodes[node].rotation);
        }

        private static Rigidbody? FindBody(Transform node) =>
            node != null && node.TryGetComponent(out Rigidbody body) ? body : null;

        private bool IsBelowMovedTransform(RetargetedPose pose, int node)
        {
            for (int above = _rig.Nodes[node].Parent; above >= 0; above = _rig.Nodes[above].Parent)
            {
                if (pose.IsDriven(above) && _bodies[above] is null)
                    return true;
            }

            return false;
        }

        // An Animator cannot move bodies, so a bone with a body mixes the motion with its rest pose.
        private void ComputeTarget(RetargetedPose pose, float weight)
        {
            Span<Numerics.Quaternion> rotations = pose.LocalRotations;
            Span<Numerics.Vector3> positions = pose.LocalPositions;
            Span<Numerics.Quaternion> turned = _target.LocalRotations;
            Span<Numerics.Vector3> moved = _target.LocalPositions;
            for (int node = 0; node < _nodes.Length; node++)
            {
                if (_bodies[node] is null && _nodes[node] != null)
                {
                    turned[node] = _nodes[node].localRotation.ToNumerics();
                    moved[node] = _nodes[node].localPosition.ToNumerics();
                }
                else
                {
                    turned[node] = weight < 1 ? Numerics.Quaternion.Slerp(_rig.Nodes[node].Rotation, rotations[node], weight) : rotations[node];
                    moved[node] = Numerics.Vector3.Lerp(_rig.Nodes[node].Position, positions[node], weight);
                }
            }

            _target.UpdateWorld();
        }
    }
}
