using System.Globalization;
using System.Numerics;
using System.Text;

namespace NeuronMocap;

internal static class Numbers
{
    extension(float)
    {
        public static bool IsFinite(float value) => !float.IsNaN(value) && !float.IsInfinity(value);

        public static bool IsNegative(float value) => BitConverter.SingleToInt32Bits(value) < 0;
    }

    extension(double)
    {
        public static bool IsFinite(double value) => !double.IsNaN(value) && !double.IsInfinity(value);
    }

    extension(Math)
    {
        public static double BitDecrement(double x) => -Math.BitIncrement(-x);

        public static double BitIncrement(double x) =>
            x == 0 ? double.Epsilon : BitConverter.Int64BitsToDouble(BitConverter.DoubleToInt64Bits(x) + (x > 0 ? 1 : -1));

        // Exact: a power of two has one bit, and the product of both steps is rounded once at most.
        public static double ScaleB(double x, int n) => x * Math.Pow(2, n / 2) * Math.Pow(2, n - (n / 2));

        public static (double Sin, double Cos) SinCos(double x) => (Math.Sin(x), Math.Cos(x));
    }

    extension(TimeSpan)
    {
        public static TimeSpan operator *(TimeSpan time, double factor) => TimeSpan.FromTicks((long)(time.Ticks * factor));

        public static TimeSpan operator /(TimeSpan time, double divisor) => TimeSpan.FromTicks((long)(time.Ticks / divisor));
    }

    extension(ulong)
    {
        public static ulong Parse(ReadOnlySpan<char> text, NumberStyles style, IFormatProvider? provider) => ulong.Parse(text.ToString(), style, provider);
    }

    extension(Array)
    {
        public static void Clear(Array array) => Array.Clear(array, 0, array.Length);

        public static void Fill<T>(T[] array, T value) => array.AsSpan().Fill(value);
    }

    // Of positive numbers.
    public static long GetBitLength(this BigInteger value)
    {
        long length = 0;
        for (; value > 0; value >>= 1)
            length++;

        return length;
    }

    public static string Replace(this string text, string oldValue, string newValue, StringComparison comparison) =>
        Polyfills.StringPolyfills.Replace(text, oldValue, newValue, comparison);

    public static StringBuilder Append(this StringBuilder text, IFormatProvider provider, FormattableString part) => text.Append(part.ToString(provider));
}
