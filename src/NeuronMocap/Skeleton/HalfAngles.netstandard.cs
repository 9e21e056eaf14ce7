namespace NeuronMocap.Skeleton;

// In double precision: scalar code is as fast as in single precision, and results are rounded only once.
internal static partial class HalfAngles
{
    /// <summary>Computes sin(x/2) and cos(x/2).</summary>
    /// <param name="degrees">A multiple of <see cref="Granularity"/> angles. NaN and infinity give NaN.</param>
    /// <param name="sines">Receives as many sines.</param>
    /// <param name="cosines">Receives as many cosines.</param>
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

            // Every odd quadrant swaps sine and cosine. Bit 1 of the quadrant's number is the sign of the sine. Bit 1 of the next number is the sign
            // of the cosine.
            int number = double.IsNaN(quadrant) ? 0 : (int)quadrant;
            (s, c) = (number & 1) == 0 ? (s, c) : (c, s);
            sines[i] = (float)((number & 2) == 0 ? s : -s);
            cosines[i] = (float)(((number + 1) & 2) == 0 ? c : -c);
        }
    }
}
