namespace NeuronMocap.Skeleton;

// Sines and cosines of half angles in degrees, as quaternions need them, within two units in the last place for every finite angle.
//
// Degrees make the reduction exact. Half an angle crosses a quadrant every 180 degrees of the angle, and multiples of 180 are subtracted without
// rounding. Pi in radians would not allow that. The remainder, a half angle of at most 45 degrees, goes into a Taylor series. The omitted terms are
// below a hundredth of a unit.
internal static partial class HalfAngles
{
    // Spans have a length that is a multiple of the widest vector.
    public const int Granularity = 16;

    private const float QuadrantDegrees = 180;
    private const float TurnDegrees = 720;

    // Up to this value, a multiple of 180 and the difference to it are exact in binary32.
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
