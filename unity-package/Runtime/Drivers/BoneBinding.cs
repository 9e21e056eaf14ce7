#nullable enable

using System;
using UnityEngine;

namespace NeuronMocap.Unity
{
    /// <summary>Assigns a transform to a bone of the stream.</summary>
    [Serializable]
    public struct BoneBinding
    {
        /// <summary>The bone of the stream.</summary>
        [Tooltip("The bone of the stream.")]
        public Bone Bone;

        /// <summary>The transform that follows the bone.</summary>
        [Tooltip("The transform that follows the bone.")]
        public Transform? Transform;
    }
}
