namespace NeuronMocap.Skeleton;

// In double precision, which costs a scalar the same as single and gives results that are rounded once.
internal static partial class HalfAngles
{
    /// <summary>Computes sin(x/2) and cos(x/2).</summary>
    /// <param name="degrees">A multiple of <see cref="Granularity"/> angles. NaN and infinity give NaN.</param>
    /// <param name="sines">As many sines.</param>
    /// <param name="cosines">As many cosines.</param>
    public static void SinCos(Span<float> degrees, Span<float> sines, Span<float> cosines)
    {
        for (int i = 0; i < degrees.Length; i++)
        {
            double angle = degrees[i];
            if (!(Math.Abs(angle) <= LargestExact))
                angle %= TurnDegrees;

            double quadrant = Math.Floor((angle / QuadrantDegrees) + 0.5);
            double rest = angle - (quadrant * QuadrantDegrees);
            double square = rest * rest;
            double s = rest * (Sine0 + (square * (Sine1 + (square * (Sine2 + (square * (Sine3 + (square * Sine4))))))));
            double c = 1 + (square * (Cosine1 + (square * (Cosine2 + (square * (Cosine3 + (square * (Cosine4 + (square * Cosine5)))))))));

            // Every odd quadrant swaps the two; bit 1 of its number is the sine's sign, that of the next quadrant's the cosine's.
            int number = double.IsNaN(quadrant) ? 0 : (int)quadrant;
            (s, c) = (number & 1) == 0 ? (s, c) : (c, s);
            sines[i] = (float)((number & 2) == 0 ? s : -s);
            cosines[i] = (float)(((number + 1) & 2) == 0 ? c : -c);
        }
    }
}
