#nullable enable

using System;
using NeuronMocap.Retargeting;
using UnityEngine;

namespace NeuronMocap.Unity
{
    /// <summary>The weight of one bone of a Humanoid.</summary>
    [Serializable]
    public struct HumanoidBoneWeight
    {
        /// <summary>The bone.</summary>
        [Tooltip("The bone.")]
        public HumanoidBone Bone;

        /// <summary>How much of the motion the bone follows, 0 to 1. At 0 it is not changed.</summary>
        [Tooltip("How much of the motion the bone follows. At 0 it is not changed.")]
        [Range(0, 1)]
        public float Weight;
    }
}
