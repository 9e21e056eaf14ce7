#nullable enable
#if !UNITY_6000_1_OR_NEWER
using System;
#endif
using UnityEngine;

namespace NeuronMocap.Unity
{
    // The goals of feet and hands in a humanoid clip: relative to the body, and divided by the human scale. Foot IK, which is on by default where clips
    // are played, moves the feet to their goals. Without goals it would pull them to the body. The goal of a foot is at its sole.
    internal sealed class HumanoidGoals
    {
        public static readonly string[] Names = { "LeftFoot", "RightFoot", "LeftHand", "RightHand" };

#if UNITY_6000_1_OR_NEWER
        public static HumanoidGoals? Create(Animator animator) => new HumanoidGoals();
#else
        private static readonly HumanBodyBones[] Bones =
        {
            HumanBodyBones.LeftFoot, HumanBodyBones.RightFoot, HumanBodyBones.LeftHand, HumanBodyBones.RightHand,
        };

        private readonly Transform _root;
        private readonly float _scale;
        private readonly Transform[] _bones = new Transform[Names.Length];
        private readonly Quaternion[] _axes = new Quaternion[Names.Length];
        private readonly Vector3[] _soles = new Vector3[Names.Length];

        private HumanoidGoals(Animator animator, Func<Avatar, HumanBodyBones, Quaternion> getAxes)
        {
            _root = animator.transform;
            _scale = animator.humanScale > 0 ? animator.humanScale : 1;
            for (int i = 0; i < Bones.Length; i++)
            {
                _bones[i] = animator.GetBoneTransform(Bones[i])!;
                _axes[i] = getAxes(animator.avatar!, Bones[i]);
            }

            // The first axis of a foot points down.
            _soles[0] = new Vector3(animator.leftFeetBottomHeight, 0, 0);
            _soles[1] = new Vector3(animator.rightFeetBottomHeight, 0, 0);
        }

        // Set by the editor part of the package: gets the rotation from a bone's own axes to those of its muscles, which is internal in these versions
        // of Unity. In a player it stays null, but only the editor saves clips.
        internal static Func<Avatar, HumanBodyBones, Quaternion>? AxesOf { get; set; }

        public static HumanoidGoals? Create(Animator animator) => AxesOf is { } getAxes ? new HumanoidGoals(animator, getAxes) : null;
#endif

        public Vector3[] Positions { get; } = new Vector3[Names.Length];

        public Quaternion[] Rotations { get; } = new Quaternion[Names.Length];

        // pose: as Unity returned it. The position of the body is relative to the root, in metres.
        public void Read(in HumanPose pose, Vector3 bodyPosition, Quaternion bodyRotation)
        {
#if UNITY_6000_1_OR_NEWER
            pose.ikGoalPositions.CopyTo(Positions);
            pose.internalIkGoalRotations.CopyTo(Rotations);
#else
            var toBody = Quaternion.Inverse(bodyRotation);
            var toRoot = Quaternion.Inverse(_root.rotation);
            for (int i = 0; i < _bones.Length; i++)
            {
                Quaternion rotation = toRoot * _bones[i].rotation * _axes[i];
                Vector3 position = _root.InverseTransformPoint(_bones[i].position) + (rotation * _soles[i]);
                Positions[i] = toBody * (position - bodyPosition) / _scale;
                Rotations[i] = toBody * rotation;
            }
#endif
        }
    }
}
