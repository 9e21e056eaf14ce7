namespace Unity.LiveCapture;

#pragma warning disable CA1815 // Nobody compares them.
public readonly struct FrameRate(int numerator, int denominator, bool isDropFrame)
{
    public FrameRate(int frameRate)
        : this(frameRate, 1, false)
    {
    }

    public int Numerator { get; } = numerator;

    public int Denominator { get; } = denominator;

    public bool IsDropFrame { get; } = isDropFrame;

    /// <summary>In seconds.</summary>
    public double FrameInterval => (double)Denominator / Numerator;
}
