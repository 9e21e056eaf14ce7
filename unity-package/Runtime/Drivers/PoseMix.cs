#nullable enable

using System;
using NeuronMocap.Retargeting;
using Numerics = System.Numerics;

namespace NeuronMocap.Unity
{
    // The weighted mean of some poses of one figure. Each rotation takes the shortest turn from one pose to the next.
    internal sealed class PoseMix
    {
        private readonly Numerics.Quaternion[] _rotations;
        private readonly Numerics.Vector3[] _positions;

        public PoseMix(TargetRig rig)
        {
            _rotations = new Numerics.Quaternion[rig.Nodes.Length];
            _positions = new Numerics.Vector3[rig.Nodes.Length];
        }

        // The sum of the weights.
        public float Weight { get; private set; }

        public void Clear() => Weight = 0;

        public void Add(RetargetedPose pose, float weight)
        {
            Weight += weight;
            float part = weight / Weight;
            Span<Numerics.Quaternion> rotations = pose.LocalRotations;
            Span<Numerics.Vector3> positions = pose.LocalPositions;
            for (int node = 0; node < _rotations.Length; node++)
            {
                _rotations[node] = part < 1 ? Numerics.Quaternion.Slerp(_rotations[node], rotations[node], part) : rotations[node];
                _positions[node] = part < 1 ? Numerics.Vector3.Lerp(_positions[node], positions[node], part) : positions[node];
            }
        }

        // pose: a pose that was added, which knows the driven nodes.
        public void CopyTo(RetargetedPose pose)
        {
            _rotations.AsSpan().CopyTo(pose.LocalRotations);
            _positions.AsSpan().CopyTo(pose.LocalPositions);
        }
    }
}
