#nullable enable

using System;
using NeuronMocap.Retargeting;
using UnityEngine;

namespace NeuronMocap.Unity
{
    /// <summary>
    /// How much of the performer's motion each part of a figure follows, 0 to 1. A part at 0 is not changed: animations or a headset can move it.
    /// </summary>
    [Serializable]
    public sealed class PartWeights
    {
        [Tooltip("Position and rotation of the whole body.")]
        [Range(0, 1)]
        [SerializeField]
        private float _hips = 1;

        [Tooltip("Spine and chest.")]
        [Range(0, 1)]
        [SerializeField]
        private float _spine = 1;

        [Tooltip("Neck and head. At 0, a headset can turn them.")]
        [Range(0, 1)]
        [SerializeField]
        private float _head = 1;

        [Tooltip("Left shoulder, arm and hand, without the fingers.")]
        [Range(0, 1)]
        [SerializeField]
        private float _leftArm = 1;

        [Tooltip("Right shoulder, arm and hand, without the fingers.")]
        [Range(0, 1)]
        [SerializeField]
        private float _rightArm = 1;

        [Tooltip("Fingers of the left hand.")]
        [Range(0, 1)]
        [SerializeField]
        private float _leftFingers = 1;

        [Tooltip("Fingers of the right hand.")]
        [Range(0, 1)]
        [SerializeField]
        private float _rightFingers = 1;

        [Tooltip("Left leg and foot.")]
        [Range(0, 1)]
        [SerializeField]
        private float _leftLeg = 1;

        [Tooltip("Right leg and foot.")]
        [Range(0, 1)]
        [SerializeField]
        private float _rightLeg = 1;

        /// <summary>Gets the weight of one of the nine parts.</summary>
        /// <param name="part">A single part.</param>
        /// <returns>0 to 1.</returns>
        /// <exception cref="ArgumentOutOfRangeException">The value is not a single part.</exception>
        public float Get(BodyParts part) => Field(part);

        /// <summary>Sets the weight of one or more parts.</summary>
        /// <param name="parts">The parts.</param>
        /// <param name="weight">0 to 1. Values outside the range are clamped.</param>
        public void Set(BodyParts parts, float weight)
        {
            for (BodyParts part = BodyParts.Hips; part <= BodyParts.RightLeg; part = (BodyParts)((int)part << 1))
            {
                if ((parts & part) != BodyParts.None)
                    Field(part) = Mathf.Clamp01(weight);
            }
        }

        internal void CopyTo(BoneWeights weights)
        {
            for (BodyParts part = BodyParts.Hips; part <= BodyParts.RightLeg; part = (BodyParts)((int)part << 1))
                weights.SetPart(part, Mathf.Clamp01(Field(part)));
        }

        private ref float Field(BodyParts part)
        {
            switch (part)
            {
                case BodyParts.Hips: return ref _hips;
                case BodyParts.Spine: return ref _spine;
                case BodyParts.Head: return ref _head;
                case BodyParts.LeftArm: return ref _leftArm;
                case BodyParts.RightArm: return ref _rightArm;
                case BodyParts.LeftFingers: return ref _leftFingers;
                case BodyParts.RightFingers: return ref _rightFingers;
                case BodyParts.LeftLeg: return ref _leftLeg;
                case BodyParts.RightLeg: return ref _rightLeg;
                default: throw new ArgumentOutOfRangeException(nameof(part), part, "The value must be one of the nine parts of the body.");
            }
        }
    }
}
