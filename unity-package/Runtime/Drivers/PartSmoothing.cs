#nullable enable

using System;
using NeuronMocap.Motion;
using NeuronMocap.Retargeting;
using NeuronMocap.Skeleton;
using UnityEngine;

namespace NeuronMocap.Unity
{
    /// <summary>How strongly each part of the body is smoothed. Both sides share their setting, and so do hips, spine and head.</summary>
    [Serializable]
    public sealed class PartSmoothing
    {
        [Tooltip("Hips, spine, neck and head.")]
        [SerializeField]
        private SmoothingAmount _body = new SmoothingAmount(3, 2);

        [Tooltip("Shoulders, arms and hands, without the fingers.")]
        [SerializeField]
        private SmoothingAmount _arms = new SmoothingAmount(3, 2);

        [Tooltip("Fingers of both hands.")]
        [SerializeField]
        private SmoothingAmount _fingers = new SmoothingAmount(2, 2);

        [Tooltip("Legs and feet.")]
        [SerializeField]
        private SmoothingAmount _legs = new SmoothingAmount(3, 2);

        /// <summary>Gets the amount of a part of the body.</summary>
        /// <param name="part">One of the nine parts.</param>
        /// <returns>The amount of the group that the part belongs to.</returns>
        /// <exception cref="ArgumentOutOfRangeException">The value is not a single part.</exception>
        public SmoothingAmount Get(BodyParts part) => Field(part);

        /// <summary>Sets the amount of one or more parts of the body, and of all parts that share it.</summary>
        /// <param name="parts">The parts.</param>
        /// <param name="amount">The amount.</param>
        public void Set(BodyParts parts, SmoothingAmount amount)
        {
            for (BodyParts part = BodyParts.Hips; part <= BodyParts.RightLeg; part = (BodyParts)((int)part << 1))
            {
                if ((parts & part) != BodyParts.None)
                    Field(part) = amount;
            }
        }

        internal void CopyTo(PoseSmoother smoother, SkeletonVariant variant)
        {
            foreach (Bone bone in BoneHierarchy.Bones)
                smoother[bone] = Field(HumanoidBones.GetPart(bone, variant)).ToSettings();
        }

        private ref SmoothingAmount Field(BodyParts part)
        {
            switch (part)
            {
                case BodyParts.Hips:
                case BodyParts.Spine:
                case BodyParts.Head:
                    return ref _body;
                case BodyParts.LeftArm:
                case BodyParts.RightArm:
                    return ref _arms;
                case BodyParts.LeftFingers:
                case BodyParts.RightFingers:
                    return ref _fingers;
                case BodyParts.LeftLeg:
                case BodyParts.RightLeg:
                    return ref _legs;
                default:
                    throw new ArgumentOutOfRangeException(nameof(part), part, "The value must be one of the nine parts of the body.");
            }
        }
    }
}
