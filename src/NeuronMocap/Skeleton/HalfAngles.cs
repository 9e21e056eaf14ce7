namespace NeuronMocap.Skeleton;

// Sines and cosines of half of angles in degrees, as quaternions need them, within two units in the last place for every finite angle.
//
// Degrees make the reduction exact: a half angle's quadrants are 180 of them wide, so multiples of 180 are subtracted without rounding, which
// pi in radians would not allow. What remains, at most 45 degrees of half angle, goes into the Taylor series; its terms beyond
// the last one are below a hundredth of a unit.
internal static partial class HalfAngles
{
    // Spans are whole vectors of the widest kind.
    public const int Granularity = 16;

    private const float QuadrantDegrees = 180;
    private const float TurnDegrees = 720;

    // Up to here a multiple of 180 and the difference to it are exact in binary32.
    private const float LargestExact = 1 << 24;

    private const double C = Math.PI / 360;
    private const double C2 = C * C;
    private const double Sine0 = C;
    private const double Sine1 = -C * C2 / 6;
    private const double Sine2 = C * C2 * C2 / 120;
    private const double Sine3 = -C * C2 * C2 * C2 / 5040;
    private const double Sine4 = C * C2 * C2 * C2 * C2 / 362880;
    private const double Cosine1 = -C2 / 2;
    private const double Cosine2 = C2 * C2 / 24;
    private const double Cosine3 = -C2 * C2 * C2 / 720;
    private const double Cosine4 = C2 * C2 * C2 * C2 / 40320;
    private const double Cosine5 = -C2 * C2 * C2 * C2 * C2 / 3628800;
}
