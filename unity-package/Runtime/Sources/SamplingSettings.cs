#nullable enable

using System;
using NeuronMocap.Motion;

namespace NeuronMocap.Unity
{
    // How a source shows received motion.
    internal readonly struct SamplingSettings : IEquatable<SamplingSettings>
    {
        private const double MaxFrameRate = 250;

        public SamplingSettings(bool resamples, float delayMilliseconds, PoseInterpolationMethod interpolation)
        {
            Resamples = resamples;
            Delay = resamples ? Math.Max(delayMilliseconds, 0) / 1000 : 0;
            Interpolation = interpolation;
        }

        // Off: the newest frame is shown as it is.
        public bool Resamples { get; }

        public float Delay { get; }

        public PoseInterpolationMethod Interpolation { get; }

        // The buffer has room for the frames of twice the delay.
        public PoseBuffer CreateBuffer() => new PoseBuffer(new PoseBufferOptions
        {
            Delay = TimeSpan.FromSeconds(Delay),
            MaxExtrapolation = Resamples ? TimeSpan.FromMilliseconds(50) : TimeSpan.Zero,
            Interpolation = Interpolation,
            Capacity = Math.Max(64, Math.Min((int)(2 * Delay * MaxFrameRate), 4096)),
        });

        public bool Equals(SamplingSettings other) =>
            Resamples == other.Resamples && Delay.Equals(other.Delay) && Interpolation == other.Interpolation;

        public override bool Equals(object? obj) => obj is SamplingSettings other && Equals(other);

        public override int GetHashCode() => HashCode.Combine(Resamples, Delay, Interpolation);
    }
}
