namespace NeuronMocap.Motion;

/// <summary>
/// Settings of a One-Euro filter: a low-pass filter that smooths strongly at rest, and follows fast motion with little delay (G. Casiez, N. Roussel,
/// D. Vogel, CHI 2012). The default value does not smooth.
/// </summary>
/// <param name="MinCutoff">
/// The cutoff frequency at rest, in hertz. A lower value removes more noise and adds more delay. 0 switches the filter off.
/// </param>
/// <param name="Beta">
/// How much the cutoff frequency rises with speed, in hertz for each radian per second of a rotation or metre per second of a position. A
/// higher value reduces the delay of fast motion.
/// </param>
/// <param name="DerivativeCutoff">The cutoff frequency of the measured speed, in hertz. The usual value is 1.</param>
public readonly record struct SmoothingSettings(float MinCutoff, float Beta, float DerivativeCutoff)
{
    /// <summary>Gets whether the filter is off.</summary>
    public bool IsOff => MinCutoff == 0;

    /// <summary>Gets the delay that the filter adds to motion at a steady speed.</summary>
    /// <remarks>
    /// The delay is 1 / (2 pi cutoff) seconds, with the cutoff <see cref="MinCutoff"/> + <see cref="Beta"/> times the speed. It does not depend on the frame
    /// rate.
    /// </remarks>
    /// <param name="speed">The speed in radians per second, or in metres per second. 0 gives the delay at rest.</param>
    /// <returns>The delay in milliseconds; 0 if the filter is off.</returns>
    public double GetDelay(double speed = 0) => IsOff ? 0 : 1000 / (2 * Math.PI * (MinCutoff + (Beta * Math.Abs(speed))));

    internal static SmoothingSettings Checked(SmoothingSettings settings)
    {
        bool isRight = settings.MinCutoff >= 0
            && settings.Beta >= 0
            && (settings.DerivativeCutoff > 0 || settings.IsOff)
            && float.IsFinite(settings.MinCutoff + settings.Beta + settings.DerivativeCutoff);
        return isRight
            ? settings
            : throw new ArgumentOutOfRangeException(nameof(settings), settings, "The settings must be numbers, 0 or more, with a derivative cutoff above 0.");
    }
}
