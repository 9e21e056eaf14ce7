namespace NeuronMocap.Polyfills;

// The functions in double precision, rounded once to single precision.
internal static class MathF
{
    public const float PI = 3.14159274f;

    public static float Abs(float x) => Math.Abs(x);

    public static float Acos(float x) => (float)Math.Acos(x);

    public static float Asin(float x) => (float)Math.Asin(x);

    public static float Atan2(float y, float x) => (float)Math.Atan2(y, x);

    public static float Cos(float x) => (float)Math.Cos(x);

    public static float Exp(float x) => (float)Math.Exp(x);

    public static float Sin(float x) => (float)Math.Sin(x);

    public static float Sqrt(float x) => (float)Math.Sqrt(x);
}
