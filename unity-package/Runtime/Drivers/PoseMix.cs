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
        private Numerics.Vector3 _hips;

        public PoseMix(TargetRig rig) => _rotations = new Numerics.Quaternion[rig.Nodes.Length];

        // The sum of the weights.
        public float Weight { get; private set; }

        public void Clear() => Weight = 0;

        public void Add(RetargetedPose pose, float weight)
        {
            Weight += weight;
            float part = weight / Weight;
            Span<Numerics.Quaternion> rotations = pose.LocalRotations;
            for (int node = 0; node < _rotations.Length; node++)
                _rotations[node] = part < 1 ? Numerics.Quaternion.Slerp(_rotations[node], rotations[node], part) : rotations[node];

            _hips = part < 1 ? Numerics.Vector3.Lerp(_hips, pose.HipsLocalPosition, part) : pose.HipsLocalPosition;
        }

        // pose: a pose that was added, which knows the driven nodes.
        public void CopyTo(RetargetedPose pose)
        {
            _rotations.AsSpan().CopyTo(pose.LocalRotations);
            pose.HipsLocalPosition = _hips;
        }
    }
}
