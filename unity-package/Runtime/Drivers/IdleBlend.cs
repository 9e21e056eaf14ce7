#nullable enable

using System;
using NeuronMocap.Retargeting;
using UnityEngine;
using Quaternion = System.Numerics.Quaternion;
using Vector3 = System.Numerics.Vector3;

namespace NeuronMocap.Unity
{
    // Blends a figure's poses to standing upright with arms down, and back. Each blend starts at the pose that was shown last.
    internal sealed class IdleBlend
    {
        // The angle of the arms below the horizontal.
        private const float ArmsDown = 75 * Mathf.Deg2Rad;

        private readonly Quaternion[] _idle;
        private readonly Quaternion[] _from;
        private readonly Quaternion[] _shown;
        private Place _idleHips;
        private Place _fromHips;
        private Place _shownHips;
        private float _progress = 1;
        private bool _isIdle;
        private bool _isBlending;

        public IdleBlend(TargetRig rig)
        {
            Rig = rig;
            var pose = new RetargetedPose(rig);
            Lower(pose, HumanoidBone.LeftUpperArm, HumanoidBone.LeftLowerArm, -1);
            Lower(pose, HumanoidBone.RightUpperArm, HumanoidBone.RightLowerArm, 1);
            _idle = pose.LocalRotations.ToArray();
            _from = new Quaternion[_idle.Length];
            _shown = new Quaternion[_idle.Length];
        }

        public TargetRig Rig { get; }

        // Changes the driver's pose. step: the fraction of the blend to add.
        public void Apply(RetargetedPose pose, bool isIdle, float step)
        {
            if (isIdle != _isIdle)
                Begin(pose, isIdle);

            _progress = Math.Min(1, _progress + step);
            _isBlending = _isIdle || _progress < 1;
            if (!_isBlending)
                return;

            pose.UpdateWorld();
            float part = Mathf.SmoothStep(0, 1, _progress);
            Place aim = _isIdle ? _idleHips : Place.OfHips(pose);
            _shownHips = new Place(Vector3.Lerp(_fromHips.Position, aim.Position, part), Quaternion.Slerp(_fromHips.Rotation, aim.Rotation, part));
            Span<Quaternion> rotations = pose.LocalRotations;
            for (int node = 0; node < rotations.Length; node++)
                rotations[node] = _shown[node] = Quaternion.Slerp(_from[node], _isIdle ? _idle[node] : rotations[node], part);

            pose.UpdateWorld();
            pose.SetWorldRotation(Rig.HipsNode, _shownHips.Rotation);
            pose.SetHipsWorldPosition(_shownHips.Position);
        }

        private void Begin(RetargetedPose pose, bool isIdle)
        {
            _isIdle = isIdle;
            _progress = 0;
            if (!_isBlending)
            {
                pose.UpdateWorld();
                pose.LocalRotations.CopyTo(_shown);
                _shownHips = Place.OfHips(pose);
            }

            _shown.CopyTo(_from, 0);
            _fromHips = _shownHips;
            if (!isIdle)
                return;

            // Upright at its current place and heading.
            Vector3 rest = Rig.RestPositions[Rig.HipsNode];
            Quaternion restRotation = Rig.RestRotations[Rig.HipsNode];
            Vector3 height = Rig.Up * Vector3.Dot(_fromHips.Position - rest, Rig.Up);
            Quaternion heading = Heading.About(Rig.Up, _fromHips.Rotation * Quaternion.Conjugate(restRotation));
            _idleHips = new Place(_fromHips.Position - height, heading * restRotation);
        }

        // Lowers an arm from any rest pose. Left is at negative X of a figure that faces Z.
        private static void Lower(RetargetedPose pose, HumanoidBone upper, HumanoidBone lower, float side)
        {
            TargetRig rig = pose.Rig;
            int arm = rig.GetNode(upper);
            int elbow = rig.GetNode(lower);
            if (arm < 0 || elbow < 0)
                return;

            var down = new Vector3(side * Mathf.Cos(ArmsDown), -Mathf.Sin(ArmsDown), 0);
            Vector3 direction = rig.RestPositions[elbow] - rig.RestPositions[arm];
            Quaternion turn = UnityEngine.Quaternion.FromToRotation(direction.ToUnity(), Vector3.Transform(down, rig.Facing).ToUnity()).ToNumerics();
            pose.SetWorldRotation(arm, turn * rig.RestRotations[arm]);
        }

        // In the space of the figure's root.
        private readonly struct Place
        {
            public Place(Vector3 position, Quaternion rotation) => (Position, Rotation) = (position, rotation);

            public Vector3 Position { get; }

            public Quaternion Rotation { get; }

            public static Place OfHips(RetargetedPose pose) => new Place(pose.WorldPositions[pose.Rig.HipsNode], pose.WorldRotations[pose.Rig.HipsNode]);
        }
    }
}
