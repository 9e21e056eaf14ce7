namespace NeuronMocap.Tool.Figures;

/// <summary>A value over time, for a chart.</summary>
/// <remarks>
/// The curve divides the time into some hundred stretches and keeps the lowest and highest value of each, in their order. No peak is lost, and the
/// size does not depend on the length of the take.
/// </remarks>
internal sealed class Curve
{
    private readonly Extremes[] _stretches;
    private readonly long _frameCount;

    public Curve(long frameCount, int stretches)
    {
        _frameCount = frameCount;
        _stretches = new Extremes[(int)Math.Min(frameCount, stretches)];
        Array.Fill(_stretches, new Extremes(-1, float.NaN, -1, float.NaN));
    }

    public float Lowest { get; private set; } = float.NaN;

    public float Highest { get; private set; } = float.NaN;

    /// <summary>Adds the value of a frame. A value that is not a number leaves a hole.</summary>
    public void Add(long frame, float value)
    {
        if (!float.IsFinite(value))
            return;

        Lowest = Lowest <= value ? Lowest : value;
        Highest = Highest >= value ? Highest : value;
        ref Extremes stretch = ref _stretches[(int)(frame * (Int128)_stretches.Length / _frameCount)];
        if (!(stretch.Low <= value))
            (stretch.LowFrame, stretch.Low) = (frame, value);
        if (!(stretch.High >= value))
            (stretch.HighFrame, stretch.High) = (frame, value);
    }

    /// <summary>Gets the kept values in the order of their frames; null for a hole.</summary>
    public IEnumerable<(long Frame, float Value)?> Points()
    {
        foreach (Extremes stretch in _stretches)
        {
            if (stretch.LowFrame < 0)
            {
                yield return null;
                continue;
            }

            bool lowFirst = stretch.LowFrame <= stretch.HighFrame;
            yield return lowFirst ? (stretch.LowFrame, stretch.Low) : (stretch.HighFrame, stretch.High);
            if (stretch.LowFrame != stretch.HighFrame)
                yield return lowFirst ? (stretch.HighFrame, stretch.High) : (stretch.LowFrame, stretch.Low);
        }
    }

    private record struct Extremes(long LowFrame, float Low, long HighFrame, float High);
}
