#nullable enable

using System;
using UnityEngine;

namespace NeuronMocap.Unity
{
    /// <summary>The weight of one bone of a generic rig.</summary>
    [Serializable]
    public struct StreamBoneWeight
    {
        /// <summary>The bone of the stream.</summary>
        [Tooltip("The bone of the stream.")]
        public Bone Bone;

        /// <summary>How much of the motion the bone follows, 0 to 1. At 0 it is not changed.</summary>
        [Tooltip("How much of the motion the bone follows. At 0 it is not changed.")]
        [Range(0, 1)]
        public float Weight;
    }
}
