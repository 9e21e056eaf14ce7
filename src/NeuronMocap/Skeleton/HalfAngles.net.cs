using System.Numerics;
using System.Runtime.InteropServices;

namespace NeuronMocap.Skeleton;

internal static partial class HalfAngles
{
    // The first coefficient of the sine in two parts. Rounded to one float, it would cost as much accuracy as all other steps together.
    private const float Sine0High = (float)Sine0;
    private const float Sine0Low = (float)(Sine0 - Sine0High);

    // Below this value the square has no effect. Computing it would produce denormal numbers, on which processors are a hundred times slower.
    private static Vector<float> Smallest => new(1e-3f);

    /// <summary>Computes sin(x/2) and cos(x/2).</summary>
    /// <param name="degrees">A multiple of <see cref="Granularity"/> angles. NaN and infinity give NaN.</param>
    /// <param name="sines">Receives as many sines.</param>
    /// <param name="cosines">Receives as many cosines.</param>
    public static void SinCos(Span<float> degrees, Span<float> sines, Span<float> cosines)
    {
        Span<Vector<float>> angles = MemoryMarshal.Cast<float, Vector<float>>(degrees);
        Span<Vector<float>> sine = MemoryMarshal.Cast<float, Vector<float>>(sines)[..angles.Length];
        Span<Vector<float>> cosine = MemoryMarshal.Cast<float, Vector<float>>(cosines)[..angles.Length];
        for (int i = 0; i < angles.Length; i++)
        {
            Vector<float> angle = angles[i];
            if (!Vector.LessThanOrEqualAll(Vector.Abs(angle), new Vector<float>(LargestExact)))
                angle = Reduce(angle);

            Vector<float> quadrant = Vector.Floor((angle * (1 / QuadrantDegrees)) + new Vector<float>(0.5f));
            Vector<float> rest = angle - (quadrant * QuadrantDegrees);
            Vector<float> size = Vector.ConditionalSelect(Vector.LessThan(Vector.Abs(rest), Smallest), Smallest, rest);
            Vector<float> square = size * size;
            Vector<float> s = (square * (float)Sine4) + new Vector<float>((float)Sine3);
            s = (square * s) + new Vector<float>((float)Sine2);
            s = (square * s) + new Vector<float>((float)Sine1);
            s = (square * s) + new Vector<float>(Sine0Low);
            s = (rest * Sine0High) + (rest * s);
            Vector<float> c = (square * (float)Cosine5) + new Vector<float>((float)Cosine4);
            c = (square * c) + new Vector<float>((float)Cosine3);
            c = (square * c) + new Vector<float>((float)Cosine2);
            c = (square * c) + new Vector<float>((float)Cosine1);
            c = (square * c) + Vector<float>.One;

            // Every odd quadrant swaps sine and cosine. Bit 1 of the quadrant's number is the sign of the sine. Bit 1 of the next number is the sign
            // of the cosine.
            Vector<int> number = Vector.ConvertToInt32(quadrant);
            Vector<int> odd = -(number & Vector<int>.One);
            Vector<int> sineSign = Vector.ShiftLeft(number & new Vector<int>(2), 30);
            Vector<int> cosineSign = Vector.ShiftLeft((number + Vector<int>.One) & new Vector<int>(2), 30);
            sine[i] = Vector.AsVectorSingle(Vector.AsVectorInt32(Vector.ConditionalSelect(odd, c, s)) ^ sineSign);
            cosine[i] = Vector.AsVectorSingle(Vector.AsVectorInt32(Vector.ConditionalSelect(odd, s, c)) ^ cosineSign);
        }
    }

    // The remainder of a division is exact, but far too slow for the angles of streams.
    private static Vector<float> Reduce(Vector<float> angle)
    {
        Span<float> values = stackalloc float[Vector<float>.Count];
        angle.CopyTo(values);
        for (int i = 0; i < values.Length; i++)
            values[i] %= TurnDegrees;

        return new Vector<float>(values);
    }
}
