namespace UnityEngine;

public struct Mathf
{
    public const float PI = (float)Math.PI;
    public const float Infinity = float.PositiveInfinity;
    public const float NegativeInfinity = float.NegativeInfinity;
    public const float Deg2Rad = PI * 2 / 360;
    public const float Rad2Deg = 1 / Deg2Rad;
    public static readonly float Epsilon = 1.17549435e-38f;

    public static float Sin(float f) => (float)Math.Sin(f);

    public static float Cos(float f) => (float)Math.Cos(f);

    public static float Tan(float f) => (float)Math.Tan(f);

    public static float Asin(float f) => (float)Math.Asin(f);

    public static float Acos(float f) => (float)Math.Acos(f);

    public static float Atan(float f) => (float)Math.Atan(f);

    public static float Atan2(float y, float x) => (float)Math.Atan2(y, x);

    public static float Sqrt(float f) => (float)Math.Sqrt(f);

    public static float Abs(float f) => Math.Abs(f);

    public static int Abs(int value) => Math.Abs(value);

    // Math.Min returns NaN if either argument is NaN. Unity's version compares.
    public static float Min(float a, float b) => a < b ? a : b;

    public static float Min(params float[] values) => values.Length == 0 ? 0 : values.Min();

    public static int Min(int a, int b) => Math.Min(a, b);

    public static float Max(float a, float b) => a > b ? a : b;

    public static float Max(params float[] values) => values.Length == 0 ? 0 : values.Max();

    public static int Max(int a, int b) => Math.Max(a, b);

    public static float Pow(float f, float p) => (float)Math.Pow(f, p);

    public static float Exp(float power) => (float)Math.Exp(power);

    public static float Log(float f) => (float)Math.Log(f);

    public static float Log10(float f) => (float)Math.Log10(f);

    public static float Ceil(float f) => (float)Math.Ceiling(f);

    public static float Floor(float f) => (float)Math.Floor(f);

    public static float Round(float f) => (float)Math.Round(f);

    public static int CeilToInt(float f) => (int)Math.Ceiling(f);

    public static int FloorToInt(float f) => (int)Math.Floor(f);

    public static int RoundToInt(float f) => (int)Math.Round(f);

    public static float Sign(float f) => f >= 0 ? 1 : -1;

    public static float Clamp(float value, float min, float max) => value < min ? min : value > max ? max : value;

    public static int Clamp(int value, int min, int max) => value < min ? min : value > max ? max : value;

    public static float Clamp01(float value) => Clamp(value, 0, 1);

    public static float Lerp(float a, float b, float t) => a + ((b - a) * Clamp01(t));

    public static float LerpUnclamped(float a, float b, float t) => a + ((b - a) * t);

    public static float LerpAngle(float a, float b, float t)
    {
        float delta = Repeat(b - a, 360);
        return a + ((delta > 180 ? delta - 360 : delta) * Clamp01(t));
    }

    public static float InverseLerp(float a, float b, float value) => a != b ? Clamp01((value - a) / (b - a)) : 0;

    public static float MoveTowards(float current, float target, float maxDelta) =>
        Abs(target - current) <= maxDelta ? target : current + (Sign(target - current) * maxDelta);

    public static float SmoothStep(float from, float to, float t)
    {
        t = Clamp01(t);
        return LerpUnclamped(from, to, t * t * (3 - (2 * t)));
    }

    public static float Repeat(float t, float length) => Clamp(t - (Floor(t / length) * length), 0, length);

    public static float PingPong(float t, float length) => length - Abs(Repeat(t, length * 2) - length);

    public static float DeltaAngle(float current, float target)
    {
        float delta = Repeat(target - current, 360);
        return delta > 180 ? delta - 360 : delta;
    }

    public static bool Approximately(float a, float b) => Abs(b - a) < Max(0.000001f * Max(Abs(a), Abs(b)), Epsilon * 8);

    public static float SmoothDamp(
        float current, float target, ref float currentVelocity, float smoothTime, float maxSpeed, float deltaTime)
    {
        // A critically damped spring, as documented, with the exact step of its equation.
        if (deltaTime <= 0)
            return current;

        float rate = 2 / Max(0.0001f, smoothTime);
        float most = maxSpeed * Max(0.0001f, smoothTime);
        float distance = Clamp(current - target, -most, most);
        float goal = current - distance;
        float decay = Exp(-rate * deltaTime);
        float push = (currentVelocity + (rate * distance)) * deltaTime;
        currentVelocity = (currentVelocity - (rate * push)) * decay;
        return goal + ((distance + push) * decay);
    }

    public static float SmoothDamp(float current, float target, ref float currentVelocity, float smoothTime) =>
        SmoothDamp(current, target, ref currentVelocity, smoothTime, Infinity, Time.deltaTime);

    public static bool IsPowerOfTwo(int value) => value > 0 && (value & (value - 1)) == 0;

    public static float PerlinNoise(float x, float y)
    {
        // Smooth and repeatable, which is all that code may rely on. The values differ from Unity's.
        return Clamp01(0.5f + (0.25f * Sin((x * 1.7f) + (y * 2.3f))) + (0.25f * Sin((x * 3.1f) - (y * 1.3f))));
    }
}
