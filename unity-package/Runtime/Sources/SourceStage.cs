#nullable enable

using System;
using UnityEngine;

namespace NeuronMocap.Unity
{
    /// <summary>
    /// Where the mocap stage of a <see cref="MocapSource"/> is, and how large. It applies to the poses of all performers of the source, and so to all
    /// figures, spawners, views and scripts that use them. Recordings of the source are not changed.
    /// </summary>
    [Serializable]
    public sealed class SourceStage
    {
        [Tooltip("Moves all performers of this source, in metres. The distance is the same for figures of every size.")]
        [SerializeField]
        private Vector3 _offset;

        [Tooltip("Turns the stage about the vertical axis, in degrees. 90 turns performers who face forward to the right.")]
        [Range(-180, 180)]
        [SerializeField]
        private float _heading;

        [Tooltip("Swaps left and right, as in a mirror.")]
        [SerializeField]
        private bool _mirror;

        [Tooltip("Size of the performers and of their distances. A figure with Automatic Scale keeps its own size and its own steps: scale its transform instead.")]
        [Range(0.01f, 100)]
        [SerializeField]
        private float _scale = 1;

        /// <summary>Gets or sets where the origin of the stage is, in metres. It is the same distance for figures of every size.</summary>
        public Vector3 Offset
        {
            get => _offset;
            set => _offset = value;
        }

        /// <summary>Gets or sets how far the stage is turned about the vertical axis, in degrees. Positive values turn to the right.</summary>
        public float Heading
        {
            get => _heading;
            set => _heading = value;
        }

        /// <summary>Gets or sets whether left and right are swapped. The default is false.</summary>
        public bool Mirror
        {
            get => _mirror;
            set => _mirror = value;
        }

        /// <summary>
        /// Gets or sets the size of the performers and of their distances, above 0. The default is 1. A figure whose
        /// <c>AutomaticScale</c> is on keeps its own size and its own steps.
        /// </summary>
        public float Scale
        {
            get => _scale;
            set => _scale = value;
        }
    }
}
