namespace NeuronMocap.Figures;

// Colours of figures as 0xRRGGBB in sRGB.
internal static class FigureColors
{
    public const int Body = 0xC7CCD6;

    private const float Saturation = 0.8f;
    private const float Brightness = 0.95f;

    // A distinct colour for each number, far from the colours of neighbouring numbers.
    public static int GetAccent(int number)
    {
        // Steps of the golden ratio keep successive hues far apart.
        double turn = 0.06 + (number * 0.618034);
        double sector = (turn - Math.Floor(turn)) * 6;
        double part = sector - Math.Floor(sector);
        double low = 1 - Saturation;
        double falling = 1 - (Saturation * part);
        double rising = 1 - (Saturation * (1 - part));
        return (int)sector switch
        {
            0 => Of(1, rising, low),
            1 => Of(falling, 1, low),
            2 => Of(low, 1, rising),
            3 => Of(low, falling, 1),
            4 => Of(rising, low, 1),
            _ => Of(1, low, falling),
        };
    }

    private static int Of(double red, double green, double blue) => (Level(red) << 16) | (Level(green) << 8) | Level(blue);

    private static int Level(double share) => (int)Math.Round(share * Brightness * 255);
}
