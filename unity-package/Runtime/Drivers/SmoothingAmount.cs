#nullable enable

using System;
using NeuronMocap.Motion;
using UnityEngine;

namespace NeuronMocap.Unity
{
    /// <summary>How strongly a part of the body is smoothed, by a One-Euro filter: strongly at rest, and less in fast motion.</summary>
    [Serializable]
    public struct SmoothingAmount
    {
        /// <summary>The cutoff frequency at rest, in hertz, 0.1 to 30. A lower value is smoother and later.</summary>
        [Tooltip("Cutoff frequency at rest, in hertz. A lower value removes more noise and adds more delay.")]
        [Range(0.1f, 30)]
        public float MinCutoff;

        /// <summary>
        /// How much the cutoff frequency rises with speed, 0 to 20: hertz for each radian per second. For the position of the hips, it is hertz for
        /// each metre per second.
        /// </summary>
        [Tooltip("How much the cutoff frequency rises with speed. A higher value reduces the delay of fast motion.")]
        [Range(0, 20)]
        public float Beta;

        /// <summary>The cutoff frequency of the measured speed, in hertz, 0.1 to 10. 1 suits most motion.</summary>
        [Tooltip("Cutoff frequency of the measured speed, in hertz. 1 suits most motion.")]
        [Range(0.1f, 10)]
        public float DerivativeCutoff;

        /// <summary>Creates an amount.</summary>
        /// <param name="minCutoff">The cutoff frequency at rest, in hertz.</param>
        /// <param name="beta">How much the cutoff frequency rises with speed.</param>
        /// <param name="derivativeCutoff">The cutoff frequency of the measured speed, in hertz.</param>
        public SmoothingAmount(float minCutoff, float beta, float derivativeCutoff = 1)
        {
            MinCutoff = minCutoff;
            Beta = beta;
            DerivativeCutoff = derivativeCutoff;
        }

        // Whatever a script or an old scene contains, the settings are valid.
        internal SmoothingSettings ToSettings() => new SmoothingSettings(Within(MinCutoff, 0.1f, 30), Within(Beta, 0, 20), Within(DerivativeCutoff, 0.1f, 10));

        private static float Within(float value, float least, float most) => float.IsNaN(value) ? least : Mathf.Clamp(value, least, most);
    }
}
