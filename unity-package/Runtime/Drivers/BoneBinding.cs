#nullable enable

using System;
using UnityEngine;

namespace NeuronMocap.Unity
{
    /// <summary>Which transform is a bone of the stream.</summary>
    [Serializable]
    public struct BoneBinding
    {
        /// <summary>The bone of the stream.</summary>
        [Tooltip("The bone of the stream.")]
        public Bone Bone;

        /// <summary>The transform that follows it.</summary>
        [Tooltip("The transform that follows it.")]
        public Transform? Transform;
    }
}
