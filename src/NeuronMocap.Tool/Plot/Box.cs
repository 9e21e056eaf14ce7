namespace NeuronMocap.Tool.Plot;

/// <summary>A part of the drawing, in pixels. Y points down.</summary>
internal readonly record struct Box(double Left, double Top, double Width, double Height)
{
    public double Right => Left + Width;

    public double Bottom => Top + Height;
}
