namespace NeuronMocap.Server.Sources.Synthetic;

// Curves that start and end at rest, so that neighbouring motions join smoothly. The acceleration of Step is also zero at its ends.
internal static class Easing
{
    public static float Step(float x)
    {
        x = Math.Clamp(x, 0, 1);
        return x * x * x * (10 + (x * ((6 * x) - 15)));
    }

    // Like Step, but with acceleration at the ends. It is slower in the middle and later at the end.
    public static float Glide(float x)
    {
        x = Math.Clamp(x, 0, 1);
        return x * x * (3 - (2 * x));
    }

    public static float Step(float x, float from, float to) => Step((x - from) / (to - from));

    // 0 before the first time, 1 between the second and third, 0 after the fourth.
    public static float Plateau(float x, float from, float full, float fade, float to) => Step(x, from, full) * (1 - Step(x, fade, to));

    public static float Bump(float x, float from, float peak, float to) => Plateau(x, from, peak, peak, to);

    public static float Lerp(float from, float to, float amount) => from + ((to - from) * amount);
}
